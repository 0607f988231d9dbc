#include <algorithm>
#include <iterator>

#include "mapping/comparing.hpp"

namespace asterism {
namespace {

/// Names of axioms of one set that the other does not have. What the signature says is said by any
/// set, with or without a comment.
std::vector<std::string> names_missing(const AxiomSet& axioms, const AxiomSet& other) {
  std::vector<std::string> result;
  for (const Axiom& axiom : axioms.axioms())
    if (!axiom.by_signature && !other.contains(axiom.name)) result.push_back(axiom.name);
  return result;
}

MapTree::Growth grow(MapTree& one, MapTree& other, const Visit& visit, const Stop& stop) {
  const MapTree::Growth growth = one.extend(visit, stop);
  return growth == MapTree::Growth::complete ? other.extend(visit, stop) : growth;
}

/// One trace under both, visit by visit.
class Change {
 public:
  Change(const AxiomSet& ours, Deadline deadline)
      : axioms_(ours),
        deadline_(deadline),
        check_(ours.is_shipped() ? Check::native : Check::solver) {}

  /// @return  whether to go on
  bool take(const Trace& trace, ChangeFinding& found) const {
    MapTree shipped(verify_tree_options({}, Check::native));
    MapTree ours(verify_tree_options({axioms_}, check_));
    std::vector<Association> theirs_kept, ours_kept;
    bool differs = false;
    for (std::size_t k = 0; k < trace.visits.size(); ++k) {
      const MapTree::Growth growth = grow(shipped, ours, trace.visits[k], {.deadline = deadline_});
      if (growth == MapTree::Growth::too_many) {
        ++found.cut_short;
        break;
      }
      if (growth == MapTree::Growth::stopped) {
        found.stopped_by = by_time_limit;
        return false;
      }
      theirs_kept = associations_of(shipped);
      ours_kept = associations_of(ours);
      if (differs || theirs_kept == ours_kept) continue;
      differs = true;
      if (found.smallest && found.smallest->visits.size() <= k + 1) continue;
      found.smallest = ours.trace();
      found.smallest->name = trace.name;
      found.smallest_shipped = theirs_kept.size();
      found.smallest_ours = ours_kept.size();
    }
    if (ours.undecided() > 0) {
      found.stopped_by = why_undecided(ours, deadline_);
      return false;
    }
    ++found.traces;
    found.traces_that_differ += differs ? 1 : 0;
    found.shipped += theirs_kept.size();
    found.ours += ours_kept.size();
    std::vector<Association> only;
    std::ranges::set_difference(ours_kept, theirs_kept, std::back_inserter(only));
    found.gained += only.size();
    found.lost += theirs_kept.size() + only.size() - ours_kept.size();
    return true;
  }

 private:
  const AxiomSet& axioms_;
  Deadline deadline_;
  Check check_;
};

}  // namespace

ChangeFinding compare_with_shipped(const AxiomSet& axioms, std::span<const Trace> traces,
                                   Deadline deadline,
                                   const std::function<void(std::size_t)>& progress) {
  const AxiomSet shipped = AxiomSet::shipped();
  ChangeFinding found;
  found.added = names_missing(axioms, shipped);
  found.removed = names_missing(shipped, axioms);
  for (const Axiom& axiom : axioms.axioms())
    for (const Axiom& other : shipped.axioms())
      if (axiom.name == other.name && !same_statement(axiom, other))
        found.changed.push_back(axiom.name);
  if (axioms.preference_names() != shipped.preference_names()) {
    found.preference = axioms.preference_names();
    found.shipped_preference = shipped.preference_names();
  }
  const Change change(axioms, deadline);
  for (std::size_t i = 0; i < traces.size() && change.take(traces[i], found); ++i) progress(i + 1);
  return found;
}

}  // namespace asterism
