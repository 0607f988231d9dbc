#include "engine/ask/query_reader.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace asterism {
namespace {

constexpr std::size_t most_digits = 9;
constexpr std::size_t longest_shown = 40;
constexpr std::size_t excerpt_before = 40;
constexpr std::size_t excerpt_after = 30;

constexpr std::string_view expected_claim =
    "same, differ, adjacent, on, on_path, order, path_of, places, paths, segments, steps, a "
    "number, "
    "not or '('";

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
/// A byte of UTF-8 that goes on with the character before.
bool goes_on(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }

std::size_t characters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, goes_on));
}

/// A character that begins no token, as a message shows it.
std::string shown(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  if (byte > ' ' && byte < 127) return "'" + std::string(1, text[at]) + "'";
  constexpr std::string_view digits = "0123456789abcdef";
  return std::string("byte 0x") + digits[byte / 16] + digits[byte % 16];
}

struct Token {
  enum class Kind { word, number, sign, end };
  Kind kind;
  std::string_view text;
  std::size_t at;
};

std::string shown(const Token& token) {
  if (token.kind == Token::Kind::end) return "the end";
  if (token.text.size() <= longest_shown) return "'" + std::string(token.text) + "'";
  return "'" + std::string(token.text.substr(0, longest_shown)) + "...'";
}

/// The tokens of a query, one at a time.
class Tokens {
 public:
  Tokens(std::string_view text, std::string_view kind) : text_(text), kind_(kind) { next(); }

  const Token& now() const { return now_; }
  bool is_first() const { return taken_ == 0; }
  bool is(std::string_view text) const { return now_.text == text; }
  /// Goes on behind the one that is now, which it returns.
  Token take() {
    const Token taken = now_;
    ++taken_;
    next();
    return taken;
  }
  bool take_if(std::string_view text) {
    if (!is(text)) return false;
    take();
    return true;
  }
  void require(std::string_view text) {
    if (!take_if(text)) refuse("'" + std::string(text) + "'");
  }
  [[noreturn]] void refuse(const std::string& expected) const {
    throw QueryError(text_, now_.at, shown(now_), expected, kind_);
  }
  [[noreturn]] void refuse(std::size_t at, const std::string& found,
                           const std::string& expected) const {
    throw QueryError(text_, at, found, expected, kind_);
  }

 private:
  void next() {
    std::size_t at = now_.at + now_.text.size();
    while (at < text_.size() && is_space(text_[at])) ++at;
    now_ = {Token::Kind::end, text_.substr(at, 0), at};
    if (at == text_.size()) return;
    const char first = text_[at];
    std::size_t end = at + 1;
    if (is_letter(first) || is_digit(first)) {
      while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
      now_.kind = is_letter(first) ? Token::Kind::word : Token::Kind::number;
    } else if (std::string_view("(),=!<>").find(first) != std::string_view::npos) {
      const bool may_be_longer = first == '!' || first == '<' || first == '>';
      if (may_be_longer && end < text_.size() && text_[end] == '=') ++end;
      now_.kind = Token::Kind::sign;
    } else {
      throw QueryError(text_, at, shown(text_, at), "a name, a number, a sign or a parenthesis",
                       kind_);
    }
    now_.text = text_.substr(at, end - at);
  }

  std::string_view text_;
  std::string_view kind_;  ///< of text, in messages
  std::size_t taken_ = 0;
  Token now_{Token::Kind::end, {}, 0};
};

std::string_view within_length(std::string_view text, std::string_view kind) {
  if (text.size() > max_query_length)
    throw QueryError(text, max_query_length, std::to_string(text.size()) + " bytes",
                     "at most " + std::to_string(max_query_length), kind);
  return text;
}

/// Recursive descent, a function a rule of the grammar in docs/queries.md.
class Reader {
 public:
  /// @throws QueryError if it is too long
  explicit Reader(std::string_view text, std::string_view kind = "query")
      : text_(text), tokens_(within_length(text, kind), kind) {}

  Query read() {
    Claim claim = any();
    require_end("and, or, or the end");
    return {std::string(text_), std::move(claim), std::move(mentions_)};
  }

  Question read_with_routes() {
    if (!tokens_.take_if("route")) {
      first_may_be_route_ = true;
      return read();
    }
    const auto ends = visits<std::pair<VisitId, VisitId>, 2>();
    require_end("the end, since a route is asked for alone");
    return RouteQuery{std::string(text_), ends.first, ends.second, std::move(mentions_)};
  }

  StatedAssumption read_assumption() {
    const bool is_same = tokens_.is("same");
    if (!is_same && !tokens_.is("differ")) tokens_.refuse("same or differ");
    tokens_.take();
    const Claim::Same named = visits<Claim::Same, 2>();
    require_end("the end");
    const auto kind = is_same ? Assumption::Kind::same : Assumption::Kind::differ;
    return {std::string(text_), {kind, named.one, named.other}, std::move(mentions_)};
  }

 private:
  void require_end(const std::string& expected) const {
    if (tokens_.now().kind != Token::Kind::end) tokens_.refuse(expected);
  }

  Claim any() {
    std::vector<Claim> parts{all()};
    while (tokens_.take_if("or")) parts.push_back(all());
    if (parts.size() == 1) return std::move(parts.front());
    return {Claim::Any{std::move(parts)}};
  }

  Claim all() {
    std::vector<Claim> parts{unit()};
    while (tokens_.take_if("and")) parts.push_back(unit());
    if (parts.size() == 1) return std::move(parts.front());
    return {Claim::All{std::move(parts)}};
  }

  Claim unit() {
    const Token first = tokens_.now();
    if (!tokens_.is("not") && !tokens_.is("(")) return statement();
    if (++depth_ > max_query_depth)
      tokens_.refuse(first.at, "a part inside " + std::to_string(max_query_depth) + " others",
                     "fewer parentheses and not in one another");
    tokens_.take();
    Claim claim = first.text == "(" ? any() : Claim{Claim::Not{{unit()}}};
    if (first.text == "(" && !tokens_.take_if(")")) tokens_.refuse("and, or, or ')'");
    --depth_;
    return claim;
  }

  Claim statement() {
    if (tokens_.is("path_of")) return same_path();
    if (tokens_.take_if("on")) {
      tokens_.require("(");
      const VisitId one = visit();
      tokens_.require(",");
      const VisitId left = path_of();
      tokens_.require(")");
      return {Claim::On{one, left}};
    }
    if (tokens_.take_if("same")) return of_visits<Claim::Same, 2>();
    if (tokens_.take_if("differ")) return {Claim::Not{{of_visits<Claim::Same, 2>()}}};
    if (tokens_.take_if("adjacent")) return of_visits<Claim::Adjacent, 2>();
    if (tokens_.take_if("on_path")) return of_visits<Claim::OnPath, 2>();
    if (tokens_.take_if("order")) return of_visits<Claim::Order, 3>();
    const bool may_be_route = first_may_be_route_ && tokens_.is_first();
    const Claim::Number left =
        number((may_be_route ? "route, " : "") + std::string(expected_claim));
    const Claim::Relation relation = this->relation();
    return {
        Claim::Comparison{left, relation, number("places, paths, segments, steps or a number")}};
  }

  Claim same_path() {
    const VisitId one = path_of();
    const bool is_negated = tokens_.is("!=");
    if (!is_negated && !tokens_.is("=")) tokens_.refuse("= or !=");
    tokens_.take();
    Claim same{Claim::SamePath{one, path_of()}};
    if (!is_negated) return same;
    return {Claim::Not{{std::move(same)}}};
  }

  /// @return the visit whose path it is
  VisitId path_of() {
    if (!tokens_.take_if("path_of")) tokens_.refuse("path_of");
    tokens_.require("(");
    const VisitId left = visit();
    mentions_.back().must_be_left = true;
    tokens_.require(")");
    return left;
  }

  Claim::Number number(const std::string& expected) {
    if (tokens_.now().kind == Token::Kind::number) return digits();
    if (tokens_.take_if("places")) return Extent::place;
    if (tokens_.take_if("paths")) return Extent::path;
    if (tokens_.take_if("segments")) return Extent::segment;
    if (tokens_.take_if("steps")) return visits<Claim::Steps, 2>();
    tokens_.refuse(expected);
  }

  Claim::Relation relation() {
    using enum Claim::Relation;
    constexpr std::array<std::pair<std::string_view, Claim::Relation>, 6> relations{
        {{"=", equal},
         {"!=", not_equal},
         {"<", less},
         {"<=", at_most},
         {">", greater},
         {">=", at_least}}};
    for (const auto& [sign, relation] : relations)
      if (tokens_.take_if(sign)) return relation;
    tokens_.refuse("=, !=, <, <=, > or >=");
  }

  /// What is said of as many visits, "(i, j)".
  template <class Said, std::size_t count>
  Said visits() {
    std::vector<VisitId> named;
    while (named.size() < count) {
      tokens_.require(named.empty() ? "(" : ",");
      named.push_back(visit());
    }
    tokens_.require(")");
    if constexpr (count == 2)
      return {named[0], named[1]};
    else
      return {named[0], named[1], named[2]};
  }
  template <class Said, std::size_t count>
  Claim of_visits() {
    return {visits<Said, count>()};
  }

  VisitId visit() {
    if (tokens_.now().kind != Token::Kind::number) tokens_.refuse("the number of a visit");
    const std::size_t at = tokens_.now().at;
    const VisitId visit(digits());
    mentions_.push_back({visit, at, false});
    return visit;
  }

  std::uint64_t digits() {
    const Token token = tokens_.take();
    if (!std::ranges::all_of(token.text, is_digit))
      tokens_.refuse(token.at, shown(token), "a whole number");
    if (token.text.size() > most_digits)
      tokens_.refuse(token.at, "a number of " + std::to_string(token.text.size()) + " digits",
                     "at most " + std::to_string(most_digits));
    return std::stoull(std::string(token.text));
  }

  std::string_view text_;
  Tokens tokens_;
  std::vector<Query::Mention> mentions_;
  bool first_may_be_route_ = false;
  std::size_t depth_ = 0;
};

std::string excerpt_of(std::string_view text, std::size_t at) {
  std::size_t begin = at > excerpt_before ? at - excerpt_before : 0;
  while (begin > 0 && goes_on(text[begin])) --begin;
  std::size_t end = std::min(text.size(), at + excerpt_after);
  while (end < text.size() && goes_on(text[end])) ++end;
  std::string line(text.substr(begin, end - begin));
  std::ranges::replace_if(
      line, [](char c) { return (c >= 0 && c < ' ') || c == 127; }, ' ');
  return line + '\n' + std::string(characters(text.substr(begin, at - begin)), ' ') + '^';
}

}  // namespace

std::string character_of_query(std::string_view text, std::size_t at, std::string_view kind) {
  return std::string(kind) + ", character " + std::to_string(characters(text.substr(0, at)) + 1);
}

QueryError::QueryError(std::string_view text, std::size_t at, const std::string& found,
                       const std::string& expected, std::string_view kind)
    : InputError(character_of_query(text, at, kind), found, expected),
      excerpt_(excerpt_of(text, at)) {}

Query read_query(std::string_view text) { return Reader(text).read(); }

Question read_question(std::string_view text) { return Reader(text).read_with_routes(); }

StatedAssumption read_assumption(std::string_view text) {
  return Reader(text, "assumption").read_assumption();
}

std::vector<Assumption> assumptions_of(std::span<const StatedAssumption> stated,
                                       const Trace& trace) {
  std::vector<Assumption> result;
  for (const StatedAssumption& one : stated) {
    require_visits(one, trace);
    result.push_back(one.assumption);
  }
  return result;
}

}  // namespace asterism
