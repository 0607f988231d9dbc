#pragma once

#include <cstddef>
#include <string>

namespace asterism {

/// Is this well-formed XML, as far as tags, nesting, quoted attributes and entities go?
bool is_well_formed(const std::string& xml);

std::size_t count_of(const std::string& text, const std::string& part);

}  // namespace asterism
