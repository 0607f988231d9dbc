#include "io/grid/png_image.hpp"

#include <png.h>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/shown.hpp"

namespace asterism {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view last_chunk("\0\0\0\0IEND\xae\x42\x60\x82", 12);

/// libpng's simple interface, which needs no long jumps of ours.
class Control {
 public:
  Control() { image.version = PNG_IMAGE_VERSION; }
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;
  ~Control() { png_image_free(&image); }

  std::string message() const { return printable(image.message, sizeof image.message); }

  png_image image = {};
};

}  // namespace

std::string png(const GreyImage& image) {
  require_fit(image);
  Control control;
  control.image.width = static_cast<png_uint_32>(image.width);
  control.image.height = static_cast<png_uint_32>(image.height);
  control.image.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(control.image);
  std::string result(size, '\0');
  if (!png_image_write_to_memory(&control.image, result.data(), &size, 0, image.greys.data(), 0,
                                 nullptr))
    throw Error("image: found " + control.message() + "; expected to pack it");
  result.resize(size);
  return result;
}

void write_png_file(const std::string& file, const GreyImage& image) {
  write_atomically(file, png(image));
}

GreyImage read_grey_png(std::string_view content, const std::string& file_name) {
  const std::string expected = "a grey PNG";
  if (!content.starts_with(signature))
    throw InputError(file_name, "another kind of file", expected);
  // The simple interface stops at the last row, whatever follows.
  if (!content.ends_with(last_chunk))
    throw InputError(file_name, "no end of a PNG", "one at the end of the file");
  Control control;
  if (!png_image_begin_read_from_memory(&control.image, content.data(), content.size()))
    throw InputError(file_name, control.message(), expected);
  const png_image& image = control.image;
  if (image.format != PNG_FORMAT_GRAY)
    throw InputError(file_name, "colours, transparency or 16 bits", expected + " of 8 bits");
  if (image.height > max_pixels / image.width)
    throw InputError(file_name,
                     std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels",
                     "at most " + std::to_string(max_pixels) + " pixels");
  GreyImage result{image.width, image.height};
  result.greys.resize(result.width * result.height);
  const bool is_done =
      png_image_finish_read(&control.image, nullptr, result.greys.data(), 0, nullptr) != 0;
  if (!is_done || image.warning_or_error != 0)
    throw InputError(file_name, control.message(), expected + ", undamaged");
  return result;
}

}  // namespace asterism
