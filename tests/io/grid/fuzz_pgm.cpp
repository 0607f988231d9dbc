#include "io/grid/pgm_image.hpp"
#include "tests/support/fuzz.hpp"

/// Any bytes are a picture or refused; a picture is written, and read back, as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asterism;
  const std::string bytes = fuzz_input(data, size);
  const auto image = accepted("input", [&] { return read_pgm(bytes, "input"); });
  if (!image) return 0;
  require(image->greys.size() == image->width * image->height);
  const GreyImage again = read_pgm(pgm(*image), "written");
  require(again.width == image->width && again.greys == image->greys);
  return 0;
}
