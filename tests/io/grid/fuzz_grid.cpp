#include "io/grid/grid_file.hpp"
#include "io/grid/png_image.hpp"
#include "tests/support/fuzz.hpp"

namespace {

using namespace asterism;

const std::string png_of_2_by_1 = png({2, 1, {0, 254}});

std::string json(std::size_t width, std::size_t height) {
  return "{ \"format\": \"asterism/grid\", \"version\": 1, \"resolution_m\": 0.1, \"origin\": [0, "
         "0, 0], \"width\": " +
         std::to_string(width) + ", \"height\": " + std::to_string(height) +
         ", \"image\": \"0.png\" }";
}

Grid read(const std::string& bytes) {
  if (!bytes.starts_with("\x89")) return read_grid(bytes, png_of_2_by_1, "input");
  const GreyImage image = read_grey_png(bytes, "input");
  return read_grid(json(image.width, image.height), bytes, "input");
}

}  // namespace

/// Any PNG with a description that fits, or any description with some PNG, is a grid or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz_input(data, size);
  // A picture is named by its description, beside `input`.
  if (const auto grid = accepted("", [&] { return read(bytes); }))
    require(grid->log_odds.size() ==
            static_cast<std::size_t>(grid->width) * static_cast<std::size_t>(grid->height));
  return 0;
}
