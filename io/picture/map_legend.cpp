#include "io/picture/map_legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace asterism {
namespace {

// Okabe and Ito's colours for all kinds of sight, without their yellow, which fades on white paper;
// then darker companions. Neighbouring numbers differ in lightness too.
constexpr std::array palette{"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9",
                             "#882255", "#999933", "#332288", "#44aa99", "#aa4499", "#6d4c41"};

}  // namespace

const char* path_colour(std::size_t path) { return palette[path % palette.size()]; }

std::string path_stripe(std::size_t path, double line_width) {
  // White or ink, then the same in dashes, ever shorter.
  const std::size_t lap = path / palette.size();
  if (lap == 0) return {};
  const std::size_t kind = lap - 1;
  std::string text = fmt::format("stroke=\"{}\" stroke-width=\"{:g}\"",
                                 kind % 2 == 0 ? "#ffffff" : "#1d2530", 0.36 * line_width);
  if (kind >= 2)
    text +=
        fmt::format(" stroke-dasharray=\"{0} {0}\"", std::max<std::size_t>(2, 24 / (kind / 2 + 1)));
  return text;
}

}  // namespace asterism
