#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/assumption.hpp"
#include "core/error.hpp"
#include "engine/ask/query.hpp"
#include "engine/ask/route.hpp"

namespace asterism {

/// The text of a query, or of an assumption, is not one.
class QueryError : public InputError {
 public:
  QueryError(std::string_view text, std::size_t at, const std::string& found,
             const std::string& expected, std::string_view kind = "query");

  /// Two lines: the query, or the part of a long one that matters, and a caret below the character.
  const std::string& excerpt() const { return excerpt_; }

 private:
  std::string excerpt_;
};

inline constexpr std::size_t max_query_length = 4096;  ///< bytes
inline constexpr std::size_t max_query_depth = 100;    ///< parentheses and "not" in one another

/// Reads 'same(3,9) and not on_path(0,4)': the grammar is in docs/queries.md.
/// @throws QueryError  "query, character 8: found ...; expected ..."
Query read_query(std::string_view text);

/// Whatever may be asked of the maps of a trace.
using Question = std::variant<Query, RouteQuery>;

/// Reads the same, or 'route(0,9)', which stands alone.
/// @throws QueryError
Question read_question(std::string_view text);

/// Where a byte of a query stands, as messages say it: "query, character 8", counted from 1.
std::string character_of_query(std::string_view text, std::size_t at,
                               std::string_view kind = "query");

/// An assumption as read from its text.
struct StatedAssumption {
  std::string text;
  Assumption assumption;
  std::vector<Query::Mention> mentions;  ///< two
};

/// Reads 'same(3,9)' or 'differ(2,5)'.
/// @throws QueryError  "assumption, character 8: found ...; expected ..."
StatedAssumption read_assumption(std::string_view text);

/// @throws InputError if it names a visit that the trace does not have
inline void require_visits(const StatedAssumption& stated, const Trace& trace) {
  require_visits(stated.text, stated.mentions, trace, "assumption");
}

/// What is stated, of a trace that has the visits named.
/// @throws InputError if it has not
std::vector<Assumption> assumptions_of(std::span<const StatedAssumption> stated,
                                       const Trace& trace);

}  // namespace asterism
