#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asterism {

/// A parsed s-expression: a symbol or a list, with where it stands and the comment just above it.
struct SExpr {
  std::string symbol;  ///< empty for a list
  std::vector<SExpr> list;
  std::size_t line = 0;  ///< from 1
  std::string comment;   ///< lines of the comment that ends on the line above, without ';'

  /// Whether it is a list, not a symbol.
  bool is_list() const { return symbol.empty(); }
  /// Whether it is this symbol.
  bool is(std::string_view name) const { return symbol == name; }
  /// Whether it is a list that begins with this symbol.
  bool calls(std::string_view name) const { return !list.empty() && list.front().is(name); }
  /// As SMT-LIB writes it, in one line.
  std::string text() const;
};

/// Reads the SMT-LIB 2 concrete syntax, as far as axiom files need it: no strings, no symbols in
/// bars, no empty lists, 200 levels at most.
/// @throws InputError with file and line
std::vector<SExpr> parse_sexprs(std::string_view text, const std::string& file);

}  // namespace asterism
