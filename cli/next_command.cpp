#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/grow.hpp"
#include "cli/map_parts.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "engine/exits.hpp"
#include "engine/telling_apart.hpp"
#include "io/atomic_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

using Json = nlohmann::ordered_json;

/// What was found out; nothing, where a limit ended the run.
struct NextReport {
  std::optional<std::string> stopped_by;
  std::optional<Exits> exits;
  std::optional<TellingApart> apart;
};

constexpr const char* anything_else = "anything else";

std::string maps_text(const NextCommand& command, std::uint64_t count) {
  return fmt::format("{} {}map{}", count, command.map.options.planar ? "planar " : "",
                     count == 1 ? "" : "s");
}

/// "h+ 2 0": the arm to leave the last visit by, then arms clockwise of the one come in by.
std::string way_text(const Visit& last, const Turns& turns) {
  const std::size_t arm = last.star.clockwise(last.entered_by.value_or(0), turns.front());
  std::string text = last.star.name(arm);
  for (const std::size_t turn : std::span(turns).subspan(1)) text += fmt::format(" {}", turn);
  return text;
}

void print_exits(const Visit& last, const Exits& found) {
  fmt::print("\n{:<12}  {:>8}  {:>8}  {:>8}\n", "exit", "expected", "known", "open");
  for (const Exit& exit : found.exits) {
    fmt::print("{:<12}  {:>8.1f}  {:>8}  {:>8}", way_text(last, exit.turns), exit.expected_left,
               exit.known, exit.open);
    if (!exit.tells) fmt::print("  tells nothing");
    fmt::print("\n");
    for (const auto& [seen, left, chance] : exit.outlooks)
      fmt::print("  {:3.0f}%  {:>6} left  {}\n", 100 * chance, left,
                 seen ? seen->text() : anything_else);
  }
  if (!found.complete) fmt::print("there may be more exits farther away\n");
}

void print_telling_apart(const Visit& last, std::size_t models, const TellingApart& apart) {
  if (models == 1) return fmt::print("\n1 minimal model: nothing to tell apart\n");
  switch (apart.answer) {
    case TellingApart::Answer::none:
      return fmt::print("\nno row of travels is sure to tell the {} minimal models apart\n", models);
    case TellingApart::Answer::out_of_bounds:
      return fmt::print("\nno row of travels was found that tells the {} minimal models apart, as far "
                        "as was looked\n",
                        models);
    case TellingApart::Answer::stopped:
      return;
    case TellingApart::Answer::found:
      break;
  }
  fmt::print("\n{} tells the {} minimal models apart\n", way_text(last, apart.turns), models);
  for (std::size_t m = 0; m < models; ++m) {
    std::vector<std::string> stars;
    for (const Star& star : apart.expected[m]) stars.push_back(star.text());
    fmt::print("  model {} expects {}\n", m, fmt::join(stars, ", then "));
  }
}

void print(const NextCommand& command, const Trace& trace, const MapTree& tree,
           const NextReport& report) {
  if (report.stopped_by) return fmt::print("undecided, stopped by {}\n", *report.stopped_by);
  if (tree.size() == 0) return fmt::print("no map explains the trace\n");
  fmt::print("{} explain the trace; the robot is where visit {} was\n",
             maps_text(command, tree.size()), trace.visits.size() - 1);
  print_exits(trace.visits.back(), *report.exits);
  print_telling_apart(trace.visits.back(), tree.minimal().size(), *report.apart);
}

}  // namespace

int next_command(const NextCommand& given) {
  NextCommand command = given;
  const Trace trace = read_trace_file(command.map.trace == "-" ? "/dev/stdin" : command.map.trace);
  const AxiomSet axioms = read_axioms(command.map);
  Progress progress(trace.visits.size(), command.map.options.time_limit_s);
  MapTree::Options options = tree_options(command.map, axioms);
  options.go_on = std::ref(progress);
  MapTree tree(std::move(options));
  NextReport report;
  report.stopped_by = grow(tree, trace, command.map, progress);
  const auto go_on = [&](std::uint64_t maps) { return progress(trace.visits.size() - 1, maps); };
  if (!report.stopped_by && tree.size() > 0) {
    report.exits = exits(tree, command.bounds, go_on);
    report.apart = tell_apart(tree);
  }
  print(command, trace, tree, report);
  return exit_consistent;
}

}  // namespace asterism
