#pragma once

#include <string>
#include <variant>

#include "tests/io/same.hpp"

namespace asterism {

/// Whether what is written, of whichever kind, is read as it was and written to the same text.
///
/// @param text_of  writes one of either kind
/// @param read     reads a text of either kind; the second argument is its name in messages
template <class Any, class TextOf, class Read>
bool is_read_back(const Any& any, TextOf text_of, Read read) {
  return std::visit(
      [&](const auto& one) {
        const std::string written = text_of(one);
        const Any again = read(written, "written");
        return same(again, one) && std::visit(text_of, again) == written;
      },
      any);
}

}  // namespace asterism
