#include <cstddef>
#include <string>

#include "io/grid/occupancy_map.hpp"
#include "io/json/checkpoint_file.hpp"
#include "io/json/expect_file.hpp"
#include "io/json/maps_file.hpp"
#include "io/json/perception_file.hpp"
#include "io/json/trace_file.hpp"
#include "io/log/pose_graph_file.hpp"
#include "io/log/relations_file.hpp"
#include "io/log/trajectory_file.hpp"
#include "tests/io/corpus.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

// Each bad file of a kind, of which there are many, with the message that bad.tsv tells.
template <class Read>
void check_refused(const std::string& kind, std::size_t at_least, Read read) {
  const auto files = bad_files(kind);
  CHECK(files.size() >= at_least);
  for (const auto& [file, message] : files) {
    INFO(file);
    CHECK_THROWS_WITH(read(file.string()), file.string() + message);
  }
}

// As files, and as texts that are called "file".
template <class Read, class ReadText>
void check_refused(const std::string& kind, std::size_t at_least, Read read, ReadText read_text) {
  check_refused(kind, at_least, read);
  for (const auto& [file, message] : bad_files(kind)) {
    INFO(file);
    CHECK_THROWS_WITH(read_text(content(file), "file"), "file" + message);
  }
}

}  // namespace

TEST_CASE("every bad file is refused, and the message says where and why", "[io][corpus]") {
  SECTION("trace") { check_refused("trace", 60, read_any_trace_file, read_any_trace); }
  SECTION("maps") { check_refused("maps", 20, read_any_maps_file, read_any_maps); }
  SECTION("expect") { check_refused("expect", 40, read_expect_file, read_expectation); }
  SECTION("checkpoint") { check_refused("checkpoint", 30, read_checkpoint_file, read_checkpoint); }
  SECTION("perception") { check_refused("perception", 12, read_perception_file, read_perception); }
  SECTION("trajectory") { check_refused("tum", 1, read_trajectory_file); }
  SECTION("reference") { check_refused("reference", 1, read_reference_file); }
  SECTION("relations") { check_refused("relations", 1, read_relations_file); }
  SECTION("pose graph") { check_refused("g2o", 1, read_pose_graph_file); }
  SECTION("PGM") { check_refused("pgm", 1, read_pgm_file); }
  SECTION("YAML of a map") { check_refused("yaml", 1, read_occupancy_map_file); }
}

}  // namespace asterism
