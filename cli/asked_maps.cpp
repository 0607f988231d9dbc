#include "cli/asked_maps.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "cli/option_checks.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"

namespace asterism {

void add_maps_of_trace(CLI::App& app, AskedMaps& asked) {
  app.add_option("trace", asked.trace, "Trace file (*.trace.json); -: stdin")->required();
  app.add_flag("--planar", asked.options.theory.planar,
               "Keep only maps that can be drawn in the plane");
  add_axiom_options(app, asked.axioms);
}

void add_check(CLI::App& app, MapOptions& options) {
  app.add_option("--check", options.check,
                 "Who decides: native, the solver alone, or both compared at every candidate")
      ->check(CLI::IsMember({"native", "solver", "both"}))
      ->capture_default_str();
}

void add_assumptions(CLI::App& app, std::vector<std::string>& texts) {
  app.add_option("--assume", texts,
                 "Keep only maps where this holds: same(I,J) or differ(I,J), visits I and J being "
                 "to one place or to two (repeatable)")
      ->type_name("FACT")
      ->allow_extra_args(false)  // queries may follow
      ->take_all();
}

void add_limits(CLI::App& app, MapOptions& options) {
  app.add_option("--max-hypotheses", options.max_hypotheses,
                 "Stop when a visit leaves more maps than this")
      ->type_name("N")
      ->check(whole_number);
  app.add_option("--time-limit", options.time_limit_s, "Stop after this many seconds")
      ->type_name("S")
      ->transform(duration);
}

CLI::Option& add_jobs(CLI::App& app, unsigned& jobs) {
  return *app.add_option("--jobs", jobs, "Threads of the search for minimal models")
              ->type_name("N")
              ->check(CLI::Range(1, 1024))
              ->capture_default_str();
}

void add_axiom_options(CLI::App& app, AxiomSource& source) {
  app.add_option("--axioms", source.folder, "Folder of axioms (*.smt2) instead of the shipped ones")
      ->type_name("DIR");
  app.add_option("--axiom", source.optional,
                 "Switch an optional axiom on; `asterism axioms` names them (repeatable)")
      ->type_name("NAME")
      ->take_all();
}

void add_over(CLI::App& app, AskedMaps& asked, const std::string& what) {
  app.add_option_function<std::string>(
         "--over", [&](const std::string& which) { asked.only_minimal = which == "minimal"; },
         what + " [all]")
      ->check(CLI::IsMember({"all", "minimal"}));
  add_jobs(app, asked.jobs);
  app.parse_complete_callback([&] {
    if (app.get_option("--jobs")->count() > 0 && !asked.only_minimal)
      throw CLI::RequiresError("--jobs", "--over minimal");
  });
}

std::string file_of(const AskedMaps& asked) {
  return asked.trace == "-" ? "/dev/stdin" : asked.trace;
}

std::vector<StatedAssumption> read_assumptions(std::span<const std::string> texts) {
  std::vector<StatedAssumption> result;
  for (const std::string& text : texts) result.push_back(read_assumption(text));
  return result;
}

Theory read_theory(AskedMaps& asked, std::vector<Assumption> assumptions) {
  Theory theory{.axioms = read_axioms(asked.axioms),
                .planar = asked.options.theory.planar,
                .assumptions = std::move(assumptions)};
  asked.options.theory = record_of(theory, asked.axioms);
  return theory;
}

std::string other_than_shipped(const AxiomSet& axioms) {
  return axioms.minimises_own() ? "other extents to minimise than the shipped ones"
                                : "other axioms than the shipped ones";
}

void require_decidable(const Theory& theory, const MapOptions& options) {
  if (options.check != "solver" && !theory.axioms.is_shipped())
    throw InputError("--axioms", other_than_shipped(theory.axioms),
                     "--check solver with them, since the native engine knows no others");
}

bool write_answer(const AskedMaps& asked, const std::string& json) {
  if (asked.json == "-") {
    fmt::print("{}", json);
    return false;
  }
  if (asked.json) write_atomically(*asked.json, json);
  return true;
}

}  // namespace asterism
