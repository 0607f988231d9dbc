#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asterism {

/// Text as it stands in XML: markup characters escaped, control characters shown as '?'.
std::string xml_text(std::string_view text);

/// Breaks text at spaces into lines of at most `width` characters where it can.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// A standalone SVG 1.1 on white paper, in the font and ink that all pictures share.
std::string svg_document(double width, double height, std::string_view title,
                         const std::string& body);

/// A file as a link that holds it: "data:image/png;base64,...".
std::string data_uri(std::string_view media_type, std::string_view bytes);

}  // namespace asterism
