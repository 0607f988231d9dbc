#include "cli/map_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "cli/map_text.hpp"
#include "core/error.hpp"
#include "engine/explain.hpp"
#include "io/atomic_file.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

/// Data associations with these places: several where a place can be entered by several arms.
std::vector<std::vector<Arrival>> parents_of(const MapCommand& command, const AxiomSet& axioms,
                                             const Trace& trace) {
  std::span<const std::size_t> wanted(command.why_not);
  wanted = wanted.first(wanted.size() - 1);
  MapTree tree(tree_options(command, axioms));
  for (std::size_t k = 0; k < wanted.size(); ++k) tree.extend(trace.visits[k]);
  std::vector<std::vector<Arrival>> result;
  tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    const bool is_wanted = std::ranges::equal(
        arrivals, wanted, {}, [](const Arrival& arrival) { return arrival.place.index(); });
    if (is_wanted) result.emplace_back(arrivals.begin(), arrivals.end());
  });
  return result;
}

}  // namespace

AxiomSet read_axioms(MapCommand& command) {
  AxiomSet axioms = command.axioms.read();
  command.options.axioms = command.axioms.folder.value_or("shipped");
  command.options.optional_axioms = command.axioms.optional;
  std::ranges::sort(command.options.optional_axioms);
  if (command.minimal) {
    // The search knows the shipped axioms, as the native engine does.
    if (!axioms.is_shipped() && command.options.check == "native") command.options.check = "solver";
    command.options.method = command.options.check == "native" ? "search" : "listing";
  }
  if (command.options.check != "solver" && !axioms.is_shipped())
    throw InputError("--axioms", "other axioms than the shipped ones",
                     "--check solver with them, since the native engine knows no others");
  return axioms;
}

void require_no_checkpoint(const MapCommand& command, const std::string& found,
                           const std::string& expected) {
  if (command.checkpoint)
    throw InputError("--checkpoint", found, expected + ", since maps listed have none");
}

std::vector<StatedAssumption> read_assumptions(std::span<const std::string> texts) {
  std::vector<StatedAssumption> result;
  for (const std::string& text : texts) result.push_back(read_assumption(text));
  return result;
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

std::string assuming_text(std::span<const Assumption> assumptions) {
  return assumptions.empty() ? "" : "assuming " + text_of(assumptions) + '\n';
}

MapTree::Options tree_options(const MapCommand& command, const AxiomSet& axioms) {
  MapTree::Options options;
  options.planar = command.options.planar;
  options.check = command.options.check == "native"   ? Check::native
                  : command.options.check == "solver" ? Check::solver
                                                      : Check::both;
  options.axioms = axioms;
  options.assumptions = command.options.assumptions;
  options.max_hypotheses = command.options.max_hypotheses.value_or(UINT64_MAX);
  return options;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error(folder.string() + ": found " + system_message(error.value()) +
                "; expected a folder to write to");
}

void remove_from(const std::filesystem::path& folder, const std::string& pattern,
                 std::size_t number) {
  std::error_code error;
  while (std::filesystem::remove(folder / fmt::format(fmt::runtime(pattern), number), error))
    ++number;
}

void write_problem(const std::filesystem::path& folder, const std::string& name, const Trace& trace,
                   std::span<const Arrival> hypothesis, const AxiomSet& axioms) {
  make_folder(folder);
  write_atomically((folder / name).string(), smt2_text(trace, hypothesis, axioms));
}

int why_not(const MapCommand& command, const AxiomSet& axioms, const Trace& trace) {
  const std::size_t k = command.why_not.size() - 1;
  if (command.why_not.size() < 2 || command.why_not.size() > trace.visits.size())
    throw InputError("--why-not", fmt::format("{} places", command.why_not.size()),
                     fmt::format("2 to {}, one a visit", trace.visits.size()));
  const auto parents = parents_of(command, axioms, trace);
  if (parents.empty())
    throw InputError("--why-not", "places that do not explain the visits before the last",
                     "those of a consistent map, so that the last alone is in question");
  bool possible = false;
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
        write_problem(*command.smt2_folder, fmt::format("why-not-{}.smt2", problems++), trace,
                      child, axioms);
      fmt::print("visit {} at place {}, in by arm {}: ", k, place, star.name(arm));
      const auto reason = explain_dropped(trace, child, axioms, command.options.planar);
      possible |= !reason;
      if (reason)
        fmt::print("dropped\n{}", refutation_text(*reason, make_map(trace, child), axioms));
      else
        fmt::print("not refuted\n");
    }
  }
  if (command.smt2_folder) remove_from(*command.smt2_folder, "why-not-{}.smt2", problems);
  return possible ? exit_consistent : exit_inconsistent;
}

}  // namespace asterism
