#include "axioms/sexpr.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace asterism {
namespace {

constexpr std::size_t max_depth = 200;

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
        comment_ += std::string(text_.substr(at_ + 1, end - at_ - 1)) + '\n';
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
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n();", at_), text_.size());
    result.symbol = text_.substr(at_, end - at_);
    at_ = end;
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
