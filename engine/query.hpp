#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/assumption.hpp"
#include "core/id.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"
#include "engine/map_list.hpp"

namespace asterism {

class QueryMap;

/// What a query says of a map, as docs/queries.md tells.
struct Claim {
  struct All {
    std::vector<Claim> parts;
  };
  struct Any {
    std::vector<Claim> parts;
  };
  struct Not {
    std::vector<Claim> part;  ///< one
  };
  struct Same {
    VisitId one, other;
  };
  struct Adjacent {
    VisitId one, other;
  };
  struct On {
    VisitId visit, path_of;
  };
  struct OnPath {
    VisitId one, other;
  };
  struct Order {
    VisitId first, second, third;
  };
  struct SamePath {
    VisitId path_of, other_path_of;
  };

  enum class Count { places, paths, segments };
  struct Steps {
    VisitId from, to;
  };
  using Number = std::variant<std::uint64_t, Count, Steps>;
  enum class Relation { equal, not_equal, less, at_most, greater, at_least };
  struct Comparison {
    Number left;
    Relation relation;
    Number right;
  };

  std::variant<All, Any, Not, Same, Adjacent, On, OnPath, Order, SamePath, Comparison> is;
};

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

/// @throws InputError if the query names a visit that the trace does not have, or asks by which
///         path the robot left one that it did not leave
void require_visits(std::string_view text, std::span<const Query::Mention> mentions,
                    const Trace& trace, std::string_view kind = "query");
inline void require_visits(const Query& query, const Trace& trace) {
  require_visits(query.text, query.mentions, trace);
}

/// @pre  the visits of the claim are visits of the map
bool holds(const Claim& claim, QueryMap& map);

enum class Modality {
  impossible,  ///< it holds in no map
  possible,    ///< in some, but not in all
  certain      ///< in all, of which there is one at least
};

/// What the maps of a trace say to a query.
struct Answer {
  std::uint64_t holds = 0;  ///< in as many maps
  std::uint64_t of = 0;
  /// Of the maps where it holds and of those where it does not, the first by (visits, entered),
  /// whatever the order in which the tree has them.                                 [DESIGN §9]
  std::optional<std::vector<Arrival>> witness = {};
  std::optional<std::vector<Arrival>> counterexample = {};

  Modality modality() const;
};

/// Asks each of the maps. Holds none of them but those of the answers.
///
/// @param go_on  asked now and then, with the number of maps so far; may be empty
/// @return  an answer a query; nothing if go_on said to stop
/// @throws  InputError if the queries name visits that the trace does not have
std::optional<std::vector<Answer>> ask(const MapList& maps, std::span<const Query> queries,
                                       const std::function<bool(std::uint64_t maps)>& go_on = {});
/// Asks all maps of the tree, or its minimal models.
inline std::optional<std::vector<Answer>> ask(
    const MapTree& tree, std::span<const Query> queries, bool only_minimal,
    const std::function<bool(std::uint64_t maps)>& go_on = {}) {
  return ask(only_minimal ? minimal_maps(tree) : all_maps(tree), queries, go_on);
}

}  // namespace asterism
