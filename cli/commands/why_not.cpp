#include "cli/commands/map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "cli/commands/map_results.hpp"
#include "cli/exit_code.hpp"
#include "cli/text/explanation_text.hpp"
#include "core/error.hpp"
#include "engine/facts.hpp"
#include "engine/proof/explain.hpp"
#include "engine/tree/map_tree.hpp"
#include "io/atomic_file.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {
namespace {

/// Data associations with these places: several where a place can be entered by several arms.
std::vector<std::vector<Arrival>> parents_of(const MapCommand& command, const Theory& theory,
                                             const Trace& trace) {
  std::span<const std::size_t> wanted(command.why_not);
  wanted = wanted.first(wanted.size() - 1);
  MapTree tree(tree_options(theory, command.maps.options));
  for (std::size_t k = 0; k < wanted.size(); ++k) tree.extend(trace.visits[k]);
  std::vector<std::vector<Arrival>> result;
  tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    const bool is_wanted = std::ranges::equal(
        arrivals, wanted, {}, [](const Arrival& arrival) { return arrival.place.index(); });
    if (is_wanted) result.emplace_back(arrivals.begin(), arrivals.end());
  });
  return result;
}

std::string verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::consistent:
      return "not refuted";
    case Verdict::inconsistent:
      return "dropped";
    case Verdict::undecided:
      break;
  }
  return fmt::format("undecided in {:.0f} s", default_explain_s);
}

}  // namespace

int why_not(const MapCommand& command, const Theory& theory, const Trace& trace) {
  const std::size_t k = command.why_not.size() - 1;
  if (command.why_not.size() < 2 || command.why_not.size() > trace.visits.size())
    throw InputError("--why-not", fmt::format("{} places", command.why_not.size()),
                     fmt::format("2 to {}, one a visit", trace.visits.size()));
  const auto parents = parents_of(command, theory, trace);
  if (parents.empty())
    throw InputError("--why-not", "places that do not explain the visits before the last",
                     "those of a consistent map, so that the last alone is in question");
  bool possible = false;
  bool undecided = false;
  std::size_t problems = 0;
  for (const auto& parent : parents) {
    const TopologicalMap before = make_map(trace, parent);
    const std::size_t place = command.why_not.back();
    if (place > before.places.size())
      throw InputError("--why-not", fmt::format("place {}", place),
                       fmt::format("at most {}, a new place", before.places.size()));
    const bool is_new = place == before.places.size();
    const Star& star = is_new ? trace.visits[k].star : before.places[place].star;
    for (std::size_t arm = 0; arm < star.size(); ++arm) {
      if (is_new && arm != trace.visits[k].entered_by) continue;
      std::vector<Arrival> child = parent;
      child.push_back({PlaceId(place), arm});
      if (command.smt2_folder)
        write_problem(*command.smt2_folder, fmt::format("why-not-{}.smt2", problems++),
                      smt2_text(trace, child, theory.axioms));
      fmt::print("visit {} at place {}, in by arm {}: ", k, place, star.name(arm));
      const Reason reason =
          explain_candidate(trace, theory, child, Stop{}.within(default_explain_s));
      possible |= reason.verdict == Verdict::consistent;
      undecided |= reason.verdict == Verdict::undecided;
      fmt::print("{}\n{}", verdict_text(reason.verdict),
                 premises_text(trace, theory.axioms, reason.clash,
                               PartialMap(child.begin(), child.end())));
    }
  }
  if (command.smt2_folder) remove_from(*command.smt2_folder, "why-not-{}.smt2", problems);
  return possible ? exit_consistent : undecided ? exit_undecided : exit_inconsistent;
}

}  // namespace asterism
