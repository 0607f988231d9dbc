#include "io/json/checkpoint_file.hpp"

#include <sstream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "io/json/digest.hpp"
#include "tests/io/corpus.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

std::string text_of(const Checkpoint& checkpoint) {
  std::ostringstream out;
  write_checkpoint(out, checkpoint);
  return out.str();
}

SearchState::Decision random_decision(RandomEngine& engine) {
  SearchState::Decision decision{ArmId(below(1000, engine))};
  if (chance(0.5, engine)) decision.same = ArmId(below(1000, engine));
  return decision;
}

SearchState random_state(RandomEngine& engine) {
  SearchState state;
  state.is_level_begun = chance(0.8, engine);
  state.limit = below(1'000'000'000, engine);
  state.refused = chance(0.3, engine) ? UINT64_MAX : below(1'000'000, engine);
  const auto random_model = [&](std::uint32_t number) {
    return SearchState::Model{ArmId(0), ArmId(UINT32_MAX), ArmId(number)};
  };
  if (chance(0.5, engine)) state.incumbent = random_model(7);
  for (std::uint32_t n = 0; n < below(4, engine); ++n) state.models.push_back(random_model(n));
  for (std::size_t n = below(4, engine); n > 0; --n) {
    SearchState::Branch branch{{}, {random_decision(engine)}};
    for (std::size_t k = below(5, engine); k > 0; --k)
      branch.decided.push_back(random_decision(engine));
    state.branches.push_back(branch);
  }
  return state;
}

}  // namespace

TEST_CASE("every good checkpoint is read and written without loss", "[io][corpus]") {
  const auto files = good_files("checkpoint");
  CHECK(files.size() >= 3);
  for (const auto& file : files) {
    INFO(file);
    CHECK(text_of(read_checkpoint_file(file)) == content(file));
  }
}

TEST_CASE("random checkpoints are read as they were written", "[io][property]") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    RandomEngine engine(seed);
    const TheoryRecord theory{
        .planar = chance(0.5, engine), .optional_axioms = {"one"}, .preference = {"path"}};
    const Checkpoint written{{"a \"name\"", "0123456789abcdef", theory}, random_state(engine)};
    const Checkpoint read = read_checkpoint(text_of(written), "again");
    REQUIRE(read.search == written.search);
    REQUIRE(read.state.is_level_begun == written.state.is_level_begun);
    REQUIRE(read.state.limit == written.state.limit);
    REQUIRE(read.state.refused == written.state.refused);
    REQUIRE(read.state.incumbent == written.state.incumbent);
    REQUIRE(read.state.models == written.state.models);
    REQUIRE(read.state.branches == written.state.branches);
  }
}

TEST_CASE("traces that differ in anything have other digests", "[io]") {
  Trace trace{.name = "t",
              .visits = {{.star = Star::parse("a+1 a-1"), .left_by = 0},
                         {.star = Star::parse("a+1 a-1"), .entered_by = 1}}};
  const std::string before = digest(trace);
  CHECK(digest(trace) == before);
  CHECK(before.size() == 16);
  trace.visits[1].entered_by = 0;
  CHECK(digest(trace) != before);
  trace.visits[1].entered_by = 1;
  trace.name = "u";
  CHECK(digest(trace) != before);
}

TEST_CASE("a checkpoint of another search is refused, and the message says what differs", "[io]") {
  const Checkpoint::Search search{"t", "0123456789abcdef"};
  const auto message = [&](const Checkpoint::Search& other) -> std::string {
    try {
      require_same_search({search, {}}, other, "file");
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  CHECK(message(search).empty());
  auto other = search;
  other.digest = "fedcba9876543210";
  CHECK(message(other) ==
        "file:/digest: found \"0123456789abcdef\"; expected \"fedcba9876543210\" as in the search "
        "to go on with");
  other = search;
  other.theory.planar = true;
  CHECK(message(other).starts_with("file:/options/planar: found false; expected true"));
  other = search;
  other.theory.optional_axioms = {"one_crossing"};
  CHECK(message(other).starts_with("file:/options/optional_axioms: found []; expected"));
  other = search;
  other.theory.preference = {"place", "path"};
  CHECK(message(other).starts_with("file:/options/preference: found"));
  other = search;
  other.theory.assumptions = {{Assumption::Kind::same, VisitId(0), VisitId(1)}};
  CHECK(message(other).starts_with("file:/options/assumptions: found []; expected"));
}

}  // namespace asterism
