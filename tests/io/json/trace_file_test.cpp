#include "io/json/trace_file.hpp"

#include <limits>
#include <random>

#include "core/error.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/json/round_trip.hpp"
#include "tests/io/same.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

std::string message_of(const std::string& text) {
  try {
    read_any_trace(text, "file");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string head = R"({ "format": "asterism/trace", "version": 1, "name": "t", )";
const std::string one_visit = R"("visits": [ { "star": "a+1 a-0" } ] })";

std::string random_text(std::mt19937_64& random) {
  static const std::vector<std::string> pieces{"a", "Z",  " ", "\"", "\\",
                                               "/", "\n", "ü", "星", "😀"};
  std::string text;
  for (auto length = random() % 6; length > 0; --length) text += pieces[random() % pieces.size()];
  return text;
}

/// Of any size, not only of those that print in few digits.
double random_number(std::mt19937_64& random) {
  const double fraction = static_cast<double>(random() >> 11) / 0x1p53 - 0.5;
  return std::ldexp(fraction, static_cast<int>(random() % 200) - 100);
}

Star random_star(std::mt19937_64& random) {
  std::vector<Arm> arms;
  for (std::size_t i = 0, size = 1 + random() % 4; i < size; ++i) {
    const bool both = random() % 2 == 0;
    const std::string label(1 + random() % 2, static_cast<char>('a' + i));
    arms.push_back({label, '+', true});
    arms.push_back({label, '-', both});
  }
  for (std::size_t i = arms.size(); i > 1; --i) std::swap(arms[i - 1], arms[random() % i]);
  return Star(arms);
}

std::vector<std::size_t> gateways(const Star& star) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < star.size(); ++i)
    if (star.has_gateway(i)) result.push_back(i);
  return result;
}

std::string random_extensions(std::mt19937_64& random) {
  static const std::vector<std::string> objects{
      "{}", R"({"x_": null})", R"({"x_b": [1, -0, 0.50, 1E5, "ü\u0000"], "x_a": {"a": {}}})"};
  return objects[random() % objects.size()];
}

Visit random_visit(std::mt19937_64& random) {
  const auto maybe = [&] { return random() % 2 == 0; };
  Visit visit{.star = random_star(random)};
  const auto ways = gateways(visit.star);
  visit.entered_by = ways[random() % ways.size()];
  visit.left_by = ways[random() % ways.size()];
  if (maybe()) visit.true_place = random_text(random);
  if (maybe()) visit.lpm = "lpm/" + std::to_string(random() % 100) + ".json";
  if (maybe()) {
    const auto first = static_cast<long long>(random() % 1000);
    visit.scans = {first, first + static_cast<long long>(random() % 1000)};
  }
  if (maybe()) {
    const double in = random_number(random);
    visit.stamps_s = {in, in + std::abs(random_number(random))};
  }
  if (maybe()) {
    // A covariance by construction: v vᵀ.
    const std::array v{random_number(random), random_number(random), random_number(random)};
    visit.displacement =
        Displacement{random_number(random), random_number(random), random_number(random), {}};
    for (std::size_t i = 0; i < 9; ++i) visit.displacement->covariance[i] = v[i / 3] * v[i % 3];
  }
  for (const std::size_t arm : ways)
    if (maybe())
      visit.gateways.push_back({visit.star.name(arm), random_number(random), random_number(random),
                                random_number(random), 1e-9 + std::abs(random_number(random))});
  visit.extensions = random_extensions(random);
  return visit;
}

}  // namespace

TEST_CASE("every good trace is read and written without loss", "[io]") {
  for (const auto& file : good_files("trace")) {
    INFO(file);
    CHECK(is_read_back(
        read_any_trace_file(file), [](const auto& one) { return trace_json(one); },
        read_any_trace));
  }
}

TEST_CASE("what a trace file says is in the trace", "[io]") {
  const Trace trace = read_trace_file(std::string(ASTERISM_SOURCE_DIR) +
                                      "/tests/corpus/trace/good/measured.trace.json");
  CHECK(trace.name == "measured");
  REQUIRE(trace.visits.size() == 2);
  const auto& [from, to] = std::tie(trace.visits[0], trace.visits[1]);
  CHECK(from.star == Star::parse("a+1 b+1 a-1 b-0"));
  CHECK_FALSE(from.entered_by);
  CHECK(from.left_by == 0U);
  CHECK(from.true_place == "N");
  CHECK(from.scans == std::array{0LL, 12LL});
  CHECK(from.stamps_s == std::array{0.25, 4.0});
  CHECK(from.lpm == "lpm/0.json");
  REQUIRE(from.gateways.size() == 2);
  CHECK(from.gateways[1].arm == "a-");
  CHECK(from.gateways[1].x_m == -1.5);
  CHECK(std::signbit(from.gateways[1].y_m));
  CHECK(from.gateways[1].heading_rad == 3.141592653589793);
  CHECK(from.gateways[1].width_m == 1.3);
  CHECK(to.entered_by == 2U);
  CHECK_FALSE(to.left_by);
  REQUIRE(to.displacement);
  CHECK(to.displacement->x_m == 12.5);
  CHECK(to.displacement->covariance ==
        std::array{0.04, 0.01, 0.0, 0.01, 0.09, -0.002, 0.0, -0.002, 0.0025});
  CHECK(to.extensions == "{}");
}

TEST_CASE("what a trace of the basic SSH says is in the experience", "[io][ssh]") {
  const std::string file =
      std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/trace/good/ssh.trace.json";
  const auto experience = std::get<Experience>(read_any_trace_file(file));
  CHECK(experience.name == "ssh");
  CHECK(experience.views == std::vector<std::string>{"a door", "a+1 b+0", "turn", "ü", "a door"});
  using Kind = Action::Kind;
  CHECK(experience.actions ==
        std::vector<Action>{
            {Kind::travel}, {Kind::turn, "right"}, {Kind::turn_around}, {Kind::turn, "90"}});
  CHECK(experience.extensions == R"({"x_by": "hand"})");
  // Where stars are needed, it is refused in one line.
  CHECK_THROWS_WITH(read_trace_file(file),
                    file + ":/kind: found \"ssh\"; expected \"hssh\", a trace with stars");
}

TEST_CASE("an experience is written a view and an action to a line", "[io][ssh]") {
  const Experience experience{.name = "line",
                              .views = {"a", "b", "a"},
                              .actions = {{Action::Kind::travel}, {Action::Kind::turn, "left"}},
                              .extensions = R"({"x_a": 1})"};
  CHECK(trace_json(experience) ==
        R"({ "format": "asterism/trace", "version": 1, "kind": "ssh", "name": "line",
  "x_a": 1,
  "experience": [
    "a", "travel",
    "b", "turn:left",
    "a" ] }
)");
}

TEST_CASE("an experience that could not be read back is not written", "[io][ssh]") {
  Experience experience{.name = "t", .views = {"a", "b"}, .actions = {{Action::Kind::travel}}};
  CHECK_NOTHROW(trace_json(experience));
  SECTION("no view") { experience.views.clear(); }
  SECTION("a view too many") { experience.views.emplace_back("c"); }
  SECTION("a view called like an action") { experience.views[1] = "turn:left"; }
  SECTION("an empty view") { experience.views[0].clear(); }
  SECTION("a turn without name") { experience.actions[0].kind = Action::Kind::turn; }
  SECTION("a travel with a name") { experience.actions[0].turn = "left"; }
  SECTION("a view not in UTF-8") { experience.views[0] = "\xff"; }
  SECTION("extensions no object") { experience.extensions = "[]"; }
  CHECK_THROWS_AS(trace_json(experience), std::invalid_argument);
}

TEST_CASE("keys that start with x_ are kept as they were written, in order", "[io]") {
  const std::string extensions = R"({"x_b": [1.50, -0, 12345678901234567890123], "x_a": {}})";
  const Trace trace = read_trace(
      head + R"("x_b": [1.50,-0,12345678901234567890123], "x_a":{}, )" + one_visit, "file");
  CHECK(trace.extensions == extensions);
  CHECK(read_trace(trace_json(trace), "again").extensions == extensions);
}

TEST_CASE("a trace is written one visit to a line", "[io]") {
  const auto file = std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/trace/good/corner.trace.json";
  CHECK(trace_json(read_trace_file(file)) ==
        R"({ "format": "asterism/trace", "version": 1, "name": "corner",
  "visits": [
    { "star": "a+1 b+1 a-1 b-0", "left_by": "a+" },
    { "star": "c+0 d+1 c-1 d-0", "entered_by": "c-", "left_by": "d+" },
    { "star": "a+1 a-0", "entered_by": "a+" } ] }
)");
}

TEST_CASE("random traces are read as they were written", "[io][property]") {
  const auto seed = GENERATE(range(0U, 300U));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  Trace trace{random_text(random), {}, random_extensions(random)};
  for (auto visits = 1 + random() % 6; visits > 0; --visits)
    trace.visits.push_back(random_visit(random));
  if (random() % 2 == 0) trace.visits.front().entered_by.reset();
  if (random() % 2 == 0) trace.visits.back().left_by.reset();
  CHECK(same(read_trace(trace_json(trace), "again"), trace));
}

TEST_CASE("nesting is limited", "[io]") {
  const auto nested = [](std::size_t depth) {
    return head + "\"x_a\": " + std::string(depth, '[') + std::string(depth, ']') + ", " +
           one_visit;
  };
  CHECK(message_of(nested(63)).empty());
  const std::string refusal =
      "file: found nesting of arrays and objects deeper than 64; expected fewer levels";
  CHECK(message_of(nested(64)) == refusal);
  CHECK(message_of(nested(1'000'000)) == refusal);
  CHECK(message_of(std::string(1'000'000, '[')) == refusal);
}

TEST_CASE("many keys are read in no more than linear time or so", "[io]") {
  std::string text = head;
  for (int i = 0; i < 100'000; ++i) text += "\"x_" + std::to_string(i) + "\": 0, ";
  CHECK(message_of(text + one_visit).empty());
  CHECK(message_of(text + "\"x_7\": 0, " + one_visit) ==
        "file:/x_7: found this key again; expected each key once");
}

TEST_CASE("size is limited", "[io]") {
  CHECK(message_of(head + one_visit + std::string(max_trace_bytes, ' ')) ==
        "file: found " + std::to_string(head.size() + one_visit.size() + max_trace_bytes) +
            " bytes; expected at most 67108864");
  CHECK_THROWS_WITH(read_trace_file("/dev/zero"),
                    "/dev/zero: found more than 67108864 bytes; expected a smaller file");
}

TEST_CASE("what is no file is not read", "[io]") {
  CHECK_THROWS_WITH(read_trace_file("no/such.trace.json"),
                    "no/such.trace.json: found no such file or directory; "
                    "expected a file that can be read");
  CHECK_THROWS_WITH(read_trace_file(ASTERISM_SOURCE_DIR),
                    ASTERISM_SOURCE_DIR ": found a directory; expected a file");
  CHECK_THROWS_AS(read_trace_file(""), InputError);
}

TEST_CASE("a trace that could not be read back is not written", "[io]") {
  Trace trace{"t", {{.star = Star::parse("a+1 a-0")}}};
  CHECK_NOTHROW(trace_json(trace));
  Visit& visit = trace.visits.front();
  SECTION("no visit") { trace.visits.clear(); }
  SECTION("left where there is no gateway") { visit.left_by = 1; }
  SECTION("no such arm") { visit.entered_by = 2; }
  SECTION("name not in UTF-8") { trace.name = "\xff"; }
  SECTION("no number") { visit.stamps_s = {0, std::numeric_limits<double>::quiet_NaN()}; }
  SECTION("infinite") { visit.displacement = Displacement{.x_m = HUGE_VAL}; }
  SECTION("no covariance") { visit.displacement = Displacement{.covariance = {-1}}; }
  SECTION("gateway of no arm") { visit.gateways = {{"b+", 0, 0, 0, 1}}; }
  SECTION("negative scan") { visit.scans = {-1, 1}; }
  SECTION("extensions no object") { trace.extensions = "[]"; }
  SECTION("extensions no JSON") { visit.extensions = "{"; }
  SECTION("extension of another name") { visit.extensions = R"({"star": 1})"; }
  CHECK_THROWS_AS(trace_json(trace), std::invalid_argument);
}

}  // namespace asterism
