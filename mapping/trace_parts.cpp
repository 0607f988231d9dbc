#include "mapping/trace_parts.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "engine/minimal/longest_explained_prefix.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {
namespace {

/// ExplainedUntil with a memory. Once something is not to be known, all is taken for explained, so
/// that whoever asks is soon done.
class Reach {
 public:
  Reach(std::size_t visits, const ExplainedUntil& until) : visits_(visits), until_(until) {}

  std::size_t operator()(std::size_t first) {
    if (!is_known_) return visits_;
    // Between two visits from which it is the same, it is the same.
    const auto after = known_.lower_bound(first);
    if (after != known_.end() &&
        (after->first == first ||
         (after != known_.begin() && std::prev(after)->second == after->second)))
      return after->second;
    const auto until = until_(first);
    is_known_ = until && *until > first;
    return is_known_ ? known_[first] = *until : visits_;
  }
  bool is_known() const { return is_known_; }

 private:
  std::size_t visits_;
  const ExplainedUntil& until_;
  std::map<std::size_t, std::size_t> known_;
  bool is_known_ = true;
};

/// Where each part may begin, from the first visit to the end of the last part.
struct Window {
  std::size_t earliest;
  std::size_t latest;
};

std::vector<Window> windows(std::size_t visits, Reach& reach) {
  std::vector<Window> result{{0, 0}};
  while (result.back().latest < visits) {
    const std::size_t latest = reach(result.back().latest);
    result.push_back({latest, latest});
  }
  // From where the part after it can still be reached: halving finds it, as reach only grows.
  for (std::size_t part = result.size() - 1; part-- > 1;) {
    std::size_t too_early = result[part - 1].latest;
    while (too_early + 1 < result[part].earliest) {
      const std::size_t first = too_early + (result[part].earliest - too_early) / 2;
      (reach(first) >= result[part + 1].earliest ? result[part].earliest : too_early) = first;
    }
  }
  return result;
}

/// The best way on from one beginning of a part.
struct Way {
  std::size_t squares = 0;  ///< of the lengths of this part and those after it
  std::size_t next = 0;     ///< where the next begins
};

}  // namespace

std::optional<std::vector<std::size_t>> fewest_cuts(std::size_t visits,
                                                    const ExplainedUntil& explained_until) {
  Reach reach(visits, explained_until);
  const std::vector<Window> parts = windows(visits, reach);
  std::vector<std::map<std::size_t, Way>> ways(parts.size());
  ways.back()[visits] = {};
  for (std::size_t part = parts.size() - 1; part-- > 0;) {
    for (std::size_t first = parts[part].earliest; first <= parts[part].latest; ++first) {
      Way& best = ways[part][first];
      for (const auto& [next, after] : ways[part + 1]) {
        if (next > reach(first)) break;
        const std::size_t squares = (next - first) * (next - first) + after.squares;
        if (squares >= best.squares) best = {squares, next};
      }
    }
  }
  if (!reach.is_known()) return std::nullopt;
  std::vector<std::size_t> cuts;
  for (std::size_t part = 0, first = 0; part + 2 < parts.size(); ++part)
    cuts.push_back(first = ways[part][first].next);
  return cuts;
}

std::optional<std::vector<std::size_t>> cuts_of(const Trace& trace, const Theory& theory,
                                                const MapOptions& options, const Stop& stop) {
  const std::size_t visits = trace.visits.size();
  const bool is_searched = options.check == "native" && visits <= MinimalSearch::max_visits;
  const auto explained_until = [&](std::size_t first) -> std::optional<std::size_t> {
    const Trace rest = part_of(trace, first, visits);
    Theory asked = theory_of_part(theory, first, visits);
    if (is_searched) {
      const auto explained = longest_explained_prefix(rest, {.theory = std::move(asked)}, stop);
      return explained ? std::optional(first + *explained) : std::nullopt;
    }
    TraceMaps maps(rest, std::move(asked), options);
    if (maps.find(stop)) return std::nullopt;
    return first + maps.explained_visits();
  };
  auto cuts = fewest_cuts(visits, explained_until);
  const auto are_parted = [&](const Assumption& assumption) {
    const auto [one, other] = std::minmax({assumption.one.index(), assumption.other.index()});
    return assumption.kind == Assumption::Kind::same &&
           std::ranges::any_of(*cuts, [&](std::size_t cut) { return one < cut && cut <= other; });
  };
  if (cuts && std::ranges::any_of(theory.assumptions, are_parted)) cuts.reset();
  return cuts;
}

Theory theory_of_part(const Theory& theory, std::size_t first, std::size_t last) {
  Theory part{theory.axioms, theory.planar};
  for (const auto& [kind, one, other] : theory.assumptions)
    if (std::min(one, other).index() >= first && std::max(one, other).index() < last)
      part.assumptions.push_back(
          {kind, VisitId(one.index() - first), VisitId(other.index() - first)});
  return part;
}

}  // namespace asterism
