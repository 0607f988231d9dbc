#include "axioms/sexpr.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace asterism {
namespace {

constexpr std::size_t max_depth = 200;
constexpr std::string_view marks_of_symbols = "~!@$%^&*_-+=<>.?/:";

bool is_of_symbol(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         marks_of_symbols.find(c) != std::string_view::npos;
}

bool is_control(char c) { return (c >= '\0' && c < ' ' && c != '\t') || c == '\x7f'; }

std::string shown(char c) {
  if (c > ' ' && c < '\x7f') return std::string("'") + c + "'";
  constexpr std::string_view digits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return std::string("byte 0x") + digits[byte >> 4] + digits[byte & 15];
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<SExpr> all() {
    std::vector<SExpr> result;
    for (skip(); at_ < text_.size(); skip()) result.push_back(next(0));
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    throw InputError(file_ + ":" + std::to_string(line_), found, expected);
  }

  /// Skips white space, gathering the comment block that touches what follows.
  void skip() {
    bool line_is_blank = false;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == ';') {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view line = text_.substr(at_ + 1, end - at_ - 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        const auto control = std::find_if(line.begin(), line.end(), is_control);
        if (control != line.end()) fail(shown(*control), "a comment without control characters");
        comment_ += std::string(line) + '\n';
        at_ = end;
        line_is_blank = false;
      } else if (c == '\n') {
        if (line_is_blank) comment_.clear();
        line_is_blank = true;
        ++line_;
        ++at_;
      } else if (c == ' ' || c == '\t' || c == '\r') {
        ++at_;
      } else {
        return;
      }
    }
  }

  SExpr next(std::size_t depth) {
    if (depth > max_depth) fail("deeper nesting", std::to_string(max_depth) + " levels at most");
    SExpr result;
    result.line = line_;
    result.comment = std::exchange(comment_, "");
    if (text_[at_] == ')') fail("')'", "an expression");
    if (text_[at_] == '(') {
      ++at_;
      for (skip(); at_ < text_.size() && text_[at_] != ')'; skip())
        result.list.push_back(next(depth + 1));
      if (at_ == text_.size())
        fail("end of file", "')' for '(' of line " + std::to_string(result.line));
      ++at_;
      if (result.list.empty()) fail("()", "an expression");
      return result;
    }
    for (; at_ < text_.size() && is_of_symbol(text_[at_]); ++at_) result.symbol += text_[at_];
    if (result.symbol.empty())
      fail(shown(text_[at_]), "a parenthesis, a plain symbol or a comment");
    return result;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::string comment_;
};

}  // namespace

std::string SExpr::text() const {
  if (!is_list()) return symbol;
  std::string result;
  for (const SExpr& part : list) result += (result.empty() ? "(" : " ") + part.text();
  return result + ")";
}

std::vector<SExpr> parse_sexprs(std::string_view text, const std::string& file) {
  return Parser(text, file).all();
}

}  // namespace asterism
