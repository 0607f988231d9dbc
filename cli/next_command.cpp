#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/asked_maps.hpp"
#include "cli/exits_svg.hpp"
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

/// What was found out: nothing where no map explains the trace, or a limit ended the run.
struct NextReport {
  std::optional<std::string> stopped_by = {};
  std::optional<Exits> exits = {};
  TellingApart apart = {};
};

std::string counted(std::uint64_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The name of the arm by which a row of travels leaves the last visit.
std::string first_arm(const Visit& last, const Turns& turns) {
  return last.star.name(last.star.clockwise(last.entered_by.value_or(0), turns.front()));
}

Turns further(const Turns& turns) { return {turns.begin() + 1, turns.end()}; }

/// "h- 2 0": the arm to leave the last visit by, then arms clockwise of the one come in by.
std::string text_of(const Visit& last, const Turns& turns) {
  std::string text = first_arm(last, turns);
  for (const std::size_t turn : further(turns)) text += fmt::format(" {}", turn);
  return text;
}

void print_exits(const Visit& last, const Exits& found) {
  fmt::print("\n{:<12} {:>12}  {:>8}  {:>8}\n", "exit", "expected", "known", "open");
  for (const Exit& exit : found.exits) {
    fmt::print("{:<12} {:>12.1f}  {:>8}  {:>8}{}\n", text_of(last, exit.turns), exit.expected_left,
               exit.known, exit.open, exit.tells ? "" : "  tells nothing");
    for (const auto& [seen, left, chance] : exit.outlooks)
      fmt::print("  {:>8.0f}% {:>12}  {}\n", 100 * chance, left,
                 seen ? seen->text() : "anything else");
  }
  if (!found.complete) fmt::print("there may be more exits, farther away\n");
}

/// A line for each star that is expected after each travel, with the models that expect it.
void print_expected(const TellingApart& apart) {
  for (std::size_t travel = 0; travel < apart.turns.size(); ++travel) {
    std::map<std::string, std::vector<std::size_t>> models;
    for (std::size_t m = 0; m < apart.expected.size(); ++m)
      if (travel < apart.expected[m].size()) models[apart.expected[m][travel].text()].push_back(m);
    for (const auto& [star, which] : models)
      fmt::print("  after travel {}: {} in {} {}\n", travel + 1, star,
                 which.size() == 1 ? "model" : "models", fmt::join(which, " "));
  }
}

void print_telling_apart(const Visit& last, std::size_t models, const TellingApart& apart) {
  if (models == 1) return fmt::print("\n1 minimal model: nothing to tell apart\n");
  if (apart.answer == TellingApart::Answer::found) {
    fmt::print("\n{} tells the {} minimal models apart\n", text_of(last, apart.turns), models);
    return print_expected(apart);
  }
  fmt::print("\n{}: {}\n", counted(models, "minimal model"),
             apart.answer == TellingApart::Answer::none
                 ? "no row of travels is sure to tell them all apart"
                 : "whether a row of travels is sure to tell them all apart is undecided, too many "
                   "having been tried");
}

void print(const NextCommand& command, const Trace& trace, const AskedMaps& maps,
           const NextReport& report) {
  if (report.stopped_by) {
    fmt::print("undecided, stopped by {}\n", *report.stopped_by);
    if (!command.only_minimal)
      fmt::print("(--over minimal needs the minimal models alone, not every map)\n");
    return;
  }
  if (!report.exits)
    return fmt::print("no map explains the trace: none is left after visit {}\n",
                      maps.explained_visits());
  const Visit& last = trace.visits.back();
  const std::uint64_t size = maps.list().size;
  const std::string noun = std::string(command.map.options.planar ? "planar " : "") +
                           (command.only_minimal ? "minimal model" : "map");
  fmt::print("{} {} the trace; the robot is where visit {} was, {}\n", counted(size, noun),
             size == 1 ? "explains" : "explain", trace.visits.size() - 1, last.star.text());
  if (command.only_minimal) fmt::print("(counted below are the minimal models alone)\n");
  print_exits(last, *report.exits);
  print_telling_apart(last, maps.minimal().size, report.apart);
}

Json json_of(const Visit& last, const Exit& exit) {
  Json outlooks = Json::array();
  for (const auto& [seen, left, chance] : exit.outlooks)
    outlooks.push_back(
        {{"seen", seen ? Json(seen->text()) : Json()}, {"left", left}, {"chance", chance}});
  return {{"leave_by", first_arm(last, exit.turns)},
          {"then", further(exit.turns)},
          {"known", exit.known},
          {"open", exit.open},
          {"expected_left", exit.expected_left},
          {"tells", exit.tells},
          {"outlooks", outlooks}};
}

Json json_of(const Visit& last, const TellingApart& apart) {
  using Answer = TellingApart::Answer;
  const bool is_found = apart.answer == Answer::found;
  const bool has_turns = is_found && !apart.turns.empty();
  Json json{{"answer", is_found ? "found" : apart.answer == Answer::none ? "none" : "undecided"}};
  json["leave_by"] = has_turns ? Json(first_arm(last, apart.turns)) : Json();
  json["then"] = has_turns ? Json(further(apart.turns)) : Json();
  json["expected"] = is_found ? Json::array() : Json();
  for (const std::vector<Star>& stars : apart.expected) {
    Json& of_model = json["expected"].emplace_back(Json::array());
    for (const Star& star : stars) of_model.push_back(star.text());
  }
  return json;
}

/// An exit a line.
void write_json(std::ostream& out, const NextCommand& command, const Trace& trace,
                const AskedMaps& maps, const NextReport& report) {
  const MapOptions& options = command.map.options;
  const Visit& last = trace.visits.back();
  Json head{{"format", "asterism/exits"}, {"version", 1}, {"trace", trace.name}};
  head["options"] = {{"planar", options.planar},
                     {"check", options.check},
                     {"axioms", options.axioms},
                     {"optional_axioms", options.optional_axioms},
                     {"max_travels", command.bounds.travels},
                     {"over", command.only_minimal ? "minimal" : "all"}};
  head["consistent"] = Json();
  if (!report.stopped_by && maps.consistent()) head["consistent"] = *maps.consistent();
  head["complete"] = !report.stopped_by;
  if (report.stopped_by) head["stopped_by"] = *report.stopped_by;
  head["more_exits"] = report.exits ? Json(!report.exits->complete) : Json();
  head["minimal"] = report.stopped_by ? Json() : Json(maps.minimal().size);
  head["tell_apart"] = report.exits ? json_of(last, report.apart) : Json();
  const std::string text = head.dump();
  out << std::string_view(text).substr(0, text.size() - 1) << ",\n  \"exits\": ";
  if (!report.exits) {
    out << "null}\n";
    return;
  }
  const char* separator = "[\n    ";
  for (const Exit& exit : report.exits->exits) {
    out << separator << json_of(last, exit).dump();
    separator = ",\n    ";
  }
  out << "]}\n";
}

std::string picture(const NextCommand& command, const Trace& trace, const AskedMaps& maps,
                    const Exits& found) {
  std::vector<NamedExit> named;
  for (const Exit& exit : found.exits)
    named.push_back({text_of(trace.visits.back(), exit.turns), exit});
  const std::string title =
      fmt::format("{}: ways on from visit {}{}", trace.name, trace.visits.size() - 1,
                  command.only_minimal         ? ", minimal models"
                  : command.map.options.planar ? ", planar maps"
                                               : "");
  return exits_svg(title, named, maps.list().size);
}

/// Finds the maps and looks out from them, as far as the limits let it.
void look_out(const NextCommand& command, const Trace& trace, AskedMaps& maps, Progress& progress,
              NextReport& report) {
  report.stopped_by = maps.find();
  if (report.stopped_by || maps.list().size == 0) return;
  const auto go_on = [&](std::uint64_t seen) { return progress(trace.visits.size() - 1, seen); };
  report.exits = exits(maps.list(), command.bounds, go_on);
  if (report.exits)
    report.apart = tell_apart(maps.minimal(), default_most_numbers,
                              [&, size = maps.list().size] { return go_on(size); });
  if (!report.exits || report.apart.answer == TellingApart::Answer::stopped) {
    report.stopped_by = progress.stopped_by();
    report.exits.reset();
  }
}

}  // namespace

int next_command(const NextCommand& given) {
  NextCommand command = given;
  const Trace trace = read_trace_file(command.map.trace == "-" ? "/dev/stdin" : command.map.trace);
  const AxiomSet axioms = read_axioms(command.map);
  if (!axioms.is_shipped())
    throw InputError("--axioms", "other axioms than the shipped ones",
                     "those, since the native engine counts what may be seen and knows no others");

  Progress progress(trace.visits.size(), command.map.options.time_limit_s);
  AskedMaps maps(command.map, axioms, trace, command.only_minimal, progress);
  NextReport report;
  look_out(command, trace, maps, progress, report);

  if (command.svg && report.exits)
    write_atomically(*command.svg, picture(command, trace, maps, *report.exits));
  const auto write = [&](std::ostream& out) { write_json(out, command, trace, maps, report); };
  if (command.map.json == "-") {
    write(std::cout);
  } else {
    if (command.map.json) write_atomically(*command.map.json, write);
    print(command, trace, maps, report);
  }
  if (report.stopped_by) return exit_undecided;
  return report.exits ? exit_consistent : exit_inconsistent;
}

}  // namespace asterism
