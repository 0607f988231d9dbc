#pragma once

#include <string>
#include <string_view>

namespace asterism {

/// A file as a link that holds it: "data:image/png;base64,...".
std::string data_uri(std::string_view media_type, std::string_view bytes);

}  // namespace asterism
