#include "mapping/axiom_source.hpp"

#include "core/error.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("axioms without a folder are the shipped ones, with those switched on",
          "[mapping][unit]") {
  CHECK(read_axioms({}).is_shipped());
  CHECK_FALSE(read_axioms({}).contains("one_crossing"));
  CHECK(read_axioms({.optional = {"one_crossing"}}).contains("one_crossing"));
  CHECK_THROWS_AS(read_axioms({.optional = {"no_such"}}), InputError);
  CHECK_THROWS_AS(read_axioms({.folder = "no/such/folder"}), InputError);
}

TEST_CASE("a record names the optional axioms in order and the extents of the preference",
          "[mapping][unit]") {
  const AxiomSource source{.optional = {"one_segment", "one_crossing"}};
  const Assumption apart{Assumption::Kind::differ, VisitId(0), VisitId(2)};
  const TheoryRecord record =
      record_of({.axioms = read_axioms(source), .planar = true, .assumptions = {apart}}, source);
  CHECK(record.planar);
  CHECK(record.axioms == "shipped");
  CHECK(record.optional_axioms == std::vector<std::string>{"one_crossing", "one_segment"});
  CHECK(record.preference == std::vector<std::string>{"path", "place"});
  CHECK(record.assumptions == std::vector{apart});
}

TEST_CASE("a record names the folder that axioms were read from", "[mapping][unit]") {
  const AxiomSource source{.folder = ASTERISM_SOURCE_DIR "/axioms"};
  CHECK(record_of({.axioms = read_axioms(source)}, source).axioms == *source.folder);
}
