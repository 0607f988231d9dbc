#include "io/log/relations_file.hpp"

#include "core/error.hpp"
#include "tests/io/corpus.hpp"
#include "tests/support/catch.hpp"

namespace asterism {

TEST_CASE("a line of a file of relations is one", "[io]") {
  for (const auto& file : good_files("relations")) {
    INFO(file);
    const auto relations = read_relations_file(file);
    CHECK(relations.front() == Relation{1, 2, {0.5, 0.25, -1.68221}});
    if (relations.size() == 2) CHECK(relations[1] == Relation{2, 1, {-0.5, 0, wrapped(9)}});
  }
}

}  // namespace asterism
