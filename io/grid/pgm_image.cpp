#include "io/grid/pgm_image.hpp"

#include <algorithm>
#include <charconv>

#include "core/error.hpp"
#include "io/shown.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

constexpr std::string_view blanks = " \t\n\v\f\r";
constexpr std::size_t greatest_grey = 255;
// A pixel of P2 takes four bytes, and any number of blanks; this is far more than anyone writes.
constexpr std::size_t max_pgm_bytes = 8 * max_pixels;

/// The words of a PGM, taken from the left.
class Words {
 public:
  Words(std::string_view content, const std::string& file_name)
      : rest_(content), file_(file_name) {}

  std::size_t number(const std::string& name, std::size_t low, std::size_t high) {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    const auto word = rest_.substr(0, rest_.find_first_of(blanks));
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = error == std::errc() && end == word.data() + word.size();
    if (!is_number || value < low || value > high)
      refuse(word.empty() ? "the end of the file" : shown(word),
             name + ", an integer from " + std::to_string(low) + " to " + std::to_string(high));
    rest_.remove_prefix(word.size());
    return value;
  }

  /// A number of the head, where comments run from # to the end of their line.
  std::size_t head_number(const std::string& name, std::size_t low, std::size_t high) {
    for (;;) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
      if (!rest_.starts_with('#')) return number(name, low, high);
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
    }
  }

  /// What follows the one blank that ends the head.
  std::string_view bytes() const { return rest_.empty() ? rest_ : rest_.substr(1); }

  void end() const {
    if (const auto at = rest_.find_first_not_of(blanks); at != std::string_view::npos)
      refuse(shown(rest_.substr(at, rest_.substr(at).find_first_of(blanks))),
             "the end of the file after the last pixel");
  }

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw InputError(file_, found, expected);
  }

 private:
  std::string_view rest_;
  const std::string& file_;
};

}  // namespace

GreyImage read_pgm(std::string_view content, const std::string& file_name) {
  const bool has_bytes = content.starts_with("P5");
  if (!has_bytes && !content.starts_with("P2"))
    throw InputError(file_name, "another kind of file", "a PGM, P5 or P2");
  const auto after_magic = content.substr(2);
  if (after_magic.empty() ||
      (blanks.find(after_magic.front()) == std::string_view::npos && after_magic.front() != '#'))
    throw InputError(file_name, shown(content.substr(0, 3)), "P5 or P2 and a blank");
  Words words(after_magic, file_name);
  GreyImage image;
  image.width = words.head_number("the width", 1, max_pixels);
  image.height = words.head_number("the height", 1, max_pixels / image.width);
  words.head_number("the greatest grey", greatest_grey, greatest_grey);

  const std::size_t pixels = image.width * image.height;
  if (has_bytes) {
    const std::string_view bytes = words.bytes();
    if (bytes.size() != pixels)
      words.refuse(std::to_string(bytes.size()) + " bytes after the head",
                   std::to_string(pixels) + ", one a pixel");
    image.greys.assign(bytes.begin(), bytes.end());
    return image;
  }
  image.greys.reserve(std::min(pixels, content.size()));  // the file may be shorter than it says
  while (image.greys.size() < pixels)
    image.greys.push_back(static_cast<std::uint8_t>(words.number(
        "pixel " + std::to_string(image.greys.size() + 1) + " of " + std::to_string(pixels), 0,
        greatest_grey)));
  words.end();
  return image;
}

GreyImage read_pgm_file(const std::string& file) {
  return read_pgm(read_unpacked_file(file, max_pgm_bytes), file);
}

std::string pgm(const GreyImage& image) {
  require_fit(image);
  std::string result =
      "P5\n" + std::to_string(image.width) + ' ' + std::to_string(image.height) + "\n255\n";
  result.append(image.greys.begin(), image.greys.end());
  return result;
}

}  // namespace asterism
