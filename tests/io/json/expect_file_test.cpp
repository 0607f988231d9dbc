#include "io/json/expect_file.hpp"

#include "core/error.hpp"
#include "core/random.hpp"
#include "io/json/json_difference.hpp"
#include "tests/io/corpus.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

std::vector<std::string> differences_of(const std::string& found, const std::string& expected) {
  return differences(parse_json(found, "found"), parse_json(expected, "expected"));
}

/// One that agrees with itself, of `visits` visits.
Expectation::Case random_case(std::size_t number, RandomEngine& engine) {
  Expectation::Case one;
  one.theory.planar = chance(0.5, engine);
  one.theory.optional_axioms = {"axiom " + std::to_string(number)};
  if (chance(0.5, engine)) one.theory.optional_axioms.push_back("b \"quoted\" \xc3\xa4");
  const std::size_t visits = 1 + below(5, engine);
  std::uint64_t minimal = 0;
  if (chance(0.8, engine)) {
    one.counts.emplace().per_visit.assign(visits, 1 + below(400, engine));
    if (chance(0.2, engine)) one.counts->per_visit.back() = 0;
    const std::uint64_t consistent = one.counts->per_visit.back();
    if (consistent > 0) {
      minimal = 1 + below(consistent, engine);
      one.counts->minimal = {1 + below(5, engine), 1, minimal};
      const std::size_t spelt_out = std::min<std::size_t>(minimal, max_expected_models);
      one.counts->minimal->visits.assign(spelt_out, std::vector(visits, PlaceId(0)));
      if (chance(0.5, engine))
        one.theory.assumptions = {{Assumption::Kind::same, VisitId(0), VisitId(visits - 1)}};
    }
  }
  for (std::size_t n = below(3, engine); n > 0; --n) {
    Expectation::Question question{"same(0, 0) \n\t\"", chance(0.5, engine)};
    std::uint64_t of = below(1000, engine);
    if (one.counts) of = question.only_minimal ? minimal : one.counts->per_visit.back();
    if (chance(0.7, engine)) question.answer = {below(of + 1, engine), of};
    one.queries.push_back(question);
  }
  return one;
}

}  // namespace

TEST_CASE("every good expect file is read and written without loss", "[io][corpus]") {
  const auto files = good_files("expect");
  CHECK(files.size() >= 10);  // those of tests/traces too
  for (const auto& file : files) {
    INFO(file);
    const Expectation expectation = read_expect_file(file);
    const std::string text = expectation_json(expectation);
    CHECK(read_expectation(text, "again") == expectation);
    CHECK(expectation_json(read_expectation(text, "again")) == text);
  }
}

TEST_CASE("an expect file is written line by line as the corpus has it", "[io][corpus]") {
  const std::string file =
      std::string(ASTERISM_SOURCE_DIR) + "/tests/corpus/expect/good/all_kinds.expect.json";
  CHECK(expectation_json(read_expect_file(file)) == content(file));
}

TEST_CASE("random expectations are read as they were written", "[io][property]") {
  for (unsigned seed = 0; seed < 500; ++seed) {
    CAPTURE(seed);
    RandomEngine engine(seed);
    Expectation expectation;
    for (std::size_t n = 1 + below(3, engine); n > 0; --n)
      expectation.cases.push_back(random_case(n, engine));
    const std::string text = expectation_json(expectation);
    INFO(text);
    REQUIRE(read_expectation(text, "again") == expectation);
  }
}

TEST_CASE("a difference is told by its JSON pointer", "[io]") {
  using Lines = std::vector<std::string>;
  CHECK(differences_of("{\"a\": [1, 2], \"b\": {\"c\": null}}",
                       "{\"b\": {\"c\": null}, \"a\": [1, 2]}") == Lines{});
  CHECK(differences_of("3", "4") == Lines{": found 3; expected 4"});
  CHECK(differences_of("{\"a\": [1, 2], \"b\": {\"c/d\": 1}, \"e\": []}",
                       "{\"a\": [1, 3], \"b\": {\"c/d\": true}, \"f\": {}}") ==
        Lines{"/a: found [1, 2]; expected [1, 3]", "/b/c~1d: found 1; expected true",
              "/e: found []; expected nothing", "/f: found nothing; expected {}"});
  // Lists of lists part by part, and long ones; shorter or longer than they should be.
  CHECK(differences_of("[[1], [2], [4]]", "[[1], [3]]") ==
        Lines{"/1: found [2]; expected [3]", "/2: found [4]; expected nothing"});
  std::string ones = "[1";
  for (int i = 0; i < 40; ++i) ones += ", 1";
  CHECK(differences_of(ones + "]", ones + ", 2]") == Lines{"/41: found nothing; expected 2"});
  CHECK(differences_of("\"" + std::string(500, 'x') + "\"", "null").front().size() < 250);
}

}  // namespace asterism
