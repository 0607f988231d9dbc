#include "engine/ask/query.hpp"

#include <algorithm>
#include <array>
#include <ranges>

#include "core/error.hpp"
#include "engine/ask/query_map.hpp"
#include "engine/ask/query_reader.hpp"
#include "engine/minimal/minimal_models.hpp"

namespace asterism {
namespace {

constexpr std::uint64_t work_between_questions = 1 << 15;  ///< some tens of milliseconds

bool is_on(QueryMap& map, PlaceId place, PathId path) {
  return std::ranges::count(map.places_of(path), place) > 0;
}

void collect(const Claim& claim, bool is_negated, std::vector<Statement>& statements) {
  if (const auto* all = std::get_if<Claim::All>(&claim.is)) {
    for (const Claim& part : all->parts) collect(part, is_negated, statements);
  } else if (const auto* any = std::get_if<Claim::Any>(&claim.is)) {
    for (const Claim& part : any->parts) collect(part, is_negated, statements);
  } else if (const auto* negation = std::get_if<Claim::Not>(&claim.is)) {
    collect(negation->part.front(), !is_negated, statements);
  } else {
    statements.push_back({&claim, is_negated});
  }
}

/// Calls f(path) for all paths, until it returns true.
template <class F>
bool any_path(QueryMap& map, F&& f) {
  for (std::size_t path = 0; path < map.paths(); ++path)
    if (f(PathId(path))) return true;
  return false;
}

/// Whether one who goes along this row of places comes by the three, one after another.
template <class Places>
bool in_order(const Places& row, std::array<PlaceId, 3> wanted, std::size_t rounds) {
  std::size_t next = 0;
  for (std::size_t round = 0; round < rounds; ++round)
    for (const PlaceId place : row)
      if (place == wanted[next] && ++next == wanted.size()) return true;
  return false;
}

bool in_order(QueryMap& map, std::array<PlaceId, 3> wanted) {
  return any_path(map, [&](PathId path) {
    const std::span<const PlaceId> row = map.places_of(path);
    // Along a path that closes on itself one can go round for each.
    const std::size_t rounds = map.is_closed(path) ? wanted.size() : 1;
    return in_order(row, wanted, rounds) || in_order(std::views::reverse(row), wanted, rounds);
  });
}

std::uint64_t value(const Claim::Number& number, QueryMap& map) {
  return std::visit(Overloaded{[](std::uint64_t given) { return given; },
                               [&](Extent extent) -> std::uint64_t {
                                 return extent == Extent::place  ? map.places()
                                        : extent == Extent::path ? map.paths()
                                                                 : map.segments();
                               },
                               [&](const Claim::Steps& steps) -> std::uint64_t {
                                 return map.steps(map.place(steps.from), map.place(steps.to));
                               }},
                    number);
}

bool compare(std::uint64_t left, Claim::Relation relation, std::uint64_t right) {
  switch (relation) {
    case Claim::Relation::equal:
      return left == right;
    case Claim::Relation::not_equal:
      return left != right;
    case Claim::Relation::less:
      return left < right;
    case Claim::Relation::at_most:
      return left <= right;
    case Claim::Relation::greater:
      return left > right;
    case Claim::Relation::at_least:
      return left >= right;
  }
  return false;
}

/// Asks one map after another.
class Asking {
 public:
  Asking(const Trace& trace, std::span<const Query> queries)
      : map_(trace), queries_(queries), answers_(queries.size()) {}

  void operator()(std::span<const Arrival> arrivals) {
    map_.set(arrivals);
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const bool is_so = holds(queries_[i].claim, map_);
      Answer& answer = answers_[i];
      answer.holds += is_so ? 1 : 0;
      ++answer.of;
      auto& first = is_so ? answer.witness : answer.counterexample;
      if (!first)
        first.emplace(arrivals.begin(), arrivals.end());
      else if (is_before(arrivals, *first))
        first->assign(arrivals.begin(), arrivals.end());
    }
  }
  std::vector<Answer> answers() && { return std::move(answers_); }

 private:
  QueryMap map_;
  std::span<const Query> queries_;
  std::vector<Answer> answers_;
};

}  // namespace

std::vector<Statement> statements_of(const Claim& claim) {
  std::vector<Statement> result;
  collect(claim, false, result);
  return result;
}

void require_visits(std::string_view text, std::span<const Query::Mention> mentions,
                    const Trace& trace, std::string_view kind) {
  for (const auto& [visit, at, must_be_left] : mentions) {
    const std::string where = character_of_query(text, at, kind);
    const std::string name = "visit " + std::to_string(visit.index());
    const std::size_t visits = trace.visits.size();
    if (visit.index() >= visits)
      throw InputError(where, name,
                       visits == 1 ? "0, the only one" : "0 to " + std::to_string(visits - 1));
    if (must_be_left && !trace.visits[visit.index()].left_by)
      throw InputError(where, name + ", of which the trace does not say how it was left",
                       "one that was left");
  }
}

Claim claim_of(const Assumption& assumption) {
  const Claim same{Claim::Same{assumption.one, assumption.other}};
  return assumption.kind == Assumption::Kind::same ? same : Claim{Claim::Not{{same}}};
}

bool holds(const Claim& claim, QueryMap& map) {
  const auto in_map = [&](const Claim& part) { return holds(part, map); };
  const auto place = [&](VisitId visit) { return map.place(visit); };
  return std::visit(
      Overloaded{
          [&](const Claim::All& all) { return std::ranges::all_of(all.parts, in_map); },
          [&](const Claim::Any& any) { return std::ranges::any_of(any.parts, in_map); },
          [&](const Claim::Not& negation) { return !in_map(negation.part.front()); },
          [&](const Claim::Same& same) { return place(same.one) == place(same.other); },
          [&](const Claim::Adjacent& adjacent) {
            return map.adjacent(place(adjacent.one), place(adjacent.other));
          },
          [&](const Claim::On& on) { return is_on(map, place(on.visit), map.path_of(on.path_of)); },
          [&](const Claim::OnPath& on) {
            return any_path(map, [&](PathId path) {
              return is_on(map, place(on.one), path) && is_on(map, place(on.other), path);
            });
          },
          [&](const Claim::Order& order) {
            return in_order(map, {place(order.first), place(order.second), place(order.third)});
          },
          [&](const Claim::SamePath& same) {
            return map.path_of(same.path_of) == map.path_of(same.other_path_of);
          },
          [&](const Claim::Comparison& comparison) {
            return compare(value(comparison.left, map), comparison.relation,
                           value(comparison.right, map));
          }},
      claim.is);
}

const char* name_of(Modality modality) {
  switch (modality) {
    case Modality::certain:
      return "certain";
    case Modality::possible:
      return "possible";
    case Modality::impossible:
      break;
  }
  return "impossible";
}

Modality Answer::modality() const {
  if (holds == 0) return Modality::impossible;
  return holds == of ? Modality::certain : Modality::possible;
}

std::optional<std::vector<Answer>> ask(const MapList& maps, std::span<const Query> queries,
                                       const Stop& stop) {
  for (const Query& query : queries) require_visits(query, maps.trace);
  Asking asking(maps.trace, queries);
  std::uint64_t work_of_map = 0;
  for (const Query& query : queries) work_of_map += 1 + query.mentions.size();
  std::uint64_t asked = 0;
  std::uint64_t work = 0;
  bool stopped = false;
  maps.for_each_while([&](std::span<const Arrival> arrivals) {
    asking(arrivals);
    ++asked;
    work += work_of_map;
    if (work >= work_between_questions) {
      work = 0;
      stopped = stop.is_due({.maps = asked});
    }
    return !stopped;
  });
  if (stopped) return std::nullopt;
  return std::move(asking).answers();
}

}  // namespace asterism
