#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/assumption.hpp"
#include "core/extents.hpp"
#include "core/id.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "engine/ask/map_list.hpp"

namespace asterism {

class QueryMap;

/// What a query says of a map, as docs/queries.md tells.
struct Claim {
  /// All of the parts.
  struct All {
    std::vector<Claim> parts;
  };
  /// At least one of the parts.
  struct Any {
    std::vector<Claim> parts;
  };
  /// Not this.
  struct Not {
    std::vector<Claim> part;  ///< one
  };
  /// The visits were to one place.
  struct Same {
    VisitId one, other;
  };
  /// A segment joins the places of the visits.
  struct Adjacent {
    VisitId one, other;
  };
  /// The place of a visit is on the path by which the robot left another.
  struct On {
    VisitId visit, path_of;
  };
  /// The places of the visits are on one path.
  struct OnPath {
    VisitId one, other;
  };
  /// Along some path the places of the visits come in this order.
  struct Order {
    VisitId first, second, third;
  };
  /// The robot left the visits by one path.
  struct SamePath {
    VisitId path_of, other_path_of;
  };

  /// By how many segments the places of two visits are apart, by the shortest way.
  struct Steps {
    VisitId from, to;
  };
  /// A number given, the size of an extent, or a distance.
  using Number = std::variant<std::uint64_t, Extent, Steps>;
  /// How two numbers compare.
  enum class Relation { equal, not_equal, less, at_most, greater, at_least };
  /// Two numbers compare so.
  struct Comparison {
    Number left;
    Relation relation;
    Number right;
  };

  std::variant<All, Any, Not, Same, Adjacent, On, OnPath, Order, SamePath, Comparison> is;
};

/// One function of several, by argument: to visit what a claim is.
template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

/// One of the statements that a claim is made of by "and", "or" and "not".
struct Statement {
  const Claim* claim;
  bool is_negated;  ///< by an odd number of "not"
};

/// The statements that a claim is made of, in the order of its text. They point into it.
std::vector<Statement> statements_of(const Claim& claim);

/// What is assumed, as a claim.
Claim claim_of(const Assumption& assumption);

/// A question about the maps of a trace, as read from its text.
struct Query {
  /// A visit that the text names.
  struct Mention {
    VisitId visit;
    std::size_t at;     ///< byte of the text
    bool must_be_left;  ///< it is asked for the path faced on leaving
  };

  std::string text;
  Claim claim;
  std::vector<Mention> mentions;  ///< in the order of the text
};

/// Checks the visits that a query names, or another text of that kind.
/// @throws InputError if the query names a visit that the trace does not have, or asks by which
///         path the robot left one that it did not leave
void require_visits(std::string_view text, std::span<const Query::Mention> mentions,
                    const Trace& trace, std::string_view kind = "query");
/// Checks the visits that a query names.
/// @throws InputError if it names one that the trace does not have, or asks by which path the robot
///         left one that it did not leave
inline void require_visits(const Query& query, const Trace& trace) {
  require_visits(query.text, query.mentions, trace);
}

/// Whether a claim is true of a map.
/// @pre  the visits of the claim are visits of the map
bool holds(const Claim& claim, QueryMap& map);

/// In how many maps a query holds.
enum class Modality {
  impossible,  ///< it holds in no map
  possible,    ///< in some, but not in all
  certain      ///< in all, of which there is one at least
};

/// "impossible", "possible" or "certain".
const char* name_of(Modality modality);

/// What the maps of a trace say to a query.
struct Answer {
  std::uint64_t holds = 0;  ///< in as many maps
  std::uint64_t of = 0;
  /// Of the maps where it holds and of those where it does not, the first by (visits, entered),
  /// whatever the order in which the tree has them.                                 [theory §9]
  std::optional<std::vector<Arrival>> witness = {};
  std::optional<std::vector<Arrival>> counterexample = {};

  /// In how many of the maps asked it holds.
  Modality modality() const;
};

/// Asks each of the maps. Holds none of them but those of the answers.
///
/// @param stop  told of the maps asked so far
/// @return  an answer a query; nothing if it is to stop
/// @throws  InputError if the queries name visits that the trace does not have
std::optional<std::vector<Answer>> ask(const MapList& maps, std::span<const Query> queries,
                                       const Stop& stop = {});
/// Asks all maps of the tree, or its minimal models.
inline std::optional<std::vector<Answer>> ask(const MapTree& tree, std::span<const Query> queries,
                                              bool only_minimal, const Stop& stop = {}) {
  return ask(only_minimal ? minimal_maps(tree) : all_maps(tree), queries, stop);
}

}  // namespace asterism
