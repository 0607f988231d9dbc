#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "io/grid_file.hpp"
#include "io/png_image.hpp"

namespace {

using namespace asterism;

const std::string png_of_2_by_1 = png({2, 1, 1, {0, 254}});

std::string json(std::size_t width, std::size_t height) {
  return "{ \"format\": \"asterism/grid\", \"version\": 1, \"resolution_m\": 0.1, \"origin\": [0, "
         "0, "
         "0],"
         " \"width\": " +
         std::to_string(width) + ", \"height\": " + std::to_string(height) +
         ", \"image\": \"0.png\" }";
}

/// Any PNG with a description that fits, or any description with some PNG, is a grid or refused.
void check(std::string_view bytes) {
  try {
    Grid grid;
    if (bytes.starts_with("\x89")) {
      const PngImage image = read_grey_png(bytes, "input");
      grid = read_grid(json(image.width, image.height), bytes, "input");
    } else {
      grid = read_grid(bytes, png_of_2_by_1, "input");
    }
    if (grid.log_odds.size() !=
        static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height))
      std::abort();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    if (message.find('\n') != std::string_view::npos) std::abort();
    if (message.find(": found ") == std::string_view::npos) std::abort();
    if (message.find("; expected ") == std::string_view::npos) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  check({reinterpret_cast<const char*>(data), size});
  return 0;
}
