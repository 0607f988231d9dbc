#include "io/picture/map_legend.hpp"

#include <array>

namespace asterism {
namespace {

// Okabe and Ito's colours for all kinds of sight, without their yellow, which fades on white paper;
// then darker companions. Neighbouring numbers differ in lightness too.
constexpr std::array palette{"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9",
                             "#882255", "#999933", "#332288", "#44aa99", "#aa4499", "#6d4c41"};

}  // namespace

const char* path_colour(std::size_t path) { return palette[path % palette.size()]; }

}  // namespace asterism
