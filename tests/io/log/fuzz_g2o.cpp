#include <cmath>
#include <sstream>

#include "io/log/pose_graph_file.hpp"
#include "tests/support/fuzz.hpp"

namespace {

using namespace asterism;

PoseGraph read(const std::string& text, const std::string& name) {
  return read_pose_graph(std::make_unique<std::istringstream>(text), name);
}

// Of covariances inverted twice, relative; they may be nearly singular, to 1e-9.
constexpr double rounding = 1e-5;

}  // namespace

/// Any bytes are a pose graph or refused; a graph is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz_input(data, size);
  const auto graph = accepted("input", [&] { return read(text, "input"); });
  if (!graph) return 0;
  std::ostringstream written;
  write_pose_graph(written, *graph);
  const PoseGraph again = read(written.str(), "written");
  require(again.layout_from_place == graph->layout_from_place && again.fixed == graph->fixed);
  require(again.displacements.size() == graph->displacements.size());
  for (std::size_t i = 0; i < again.displacements.size(); ++i) {
    const auto& a = again.displacements[i];
    const auto& b = graph->displacements[i];
    require(a.from == b.from && a.to == b.to);
    require(a.displacement.x_m == b.displacement.x_m);
    const auto& one = a.displacement.covariance;
    const auto& other = b.displacement.covariance;
    for (std::size_t k = 0; k < 9; ++k)
      require(std::abs(one[k] - other[k]) <=
              rounding * std::sqrt(one[4 * (k / 3)] * one[4 * (k % 3)]));
  }
  return 0;
}
