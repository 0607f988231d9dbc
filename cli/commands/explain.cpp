#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/asked_maps.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_checks.hpp"
#include "cli/text/explanation_text.hpp"
#include "cli/text/query_text.hpp"
#include "engine/proof/ask_solver.hpp"
#include "io/atomic_file.hpp"
#include "io/json/trace_file.hpp"
#include "mapping/query_reasons.hpp"

namespace asterism {
namespace {

struct ExplainCommand {
  AskedMaps maps;
  std::string query;
  std::optional<std::string> svg;
};

/// The contrary of a query, as a query says it.
std::string contrary_text(const Query& query) {
  const std::string text = one_line(query.text);
  const bool is_negation = std::holds_alternative<Claim::Not>(query.claim.is);
  return is_negation && text.starts_with("not ") ? text.substr(4) : "not (" + text + ")";
}

int run(ExplainCommand command) {
  AskedMaps& asked = command.maps;
  const Query query = read_query(command.query);
  const auto stated = read_assumptions(asked.assume);
  const Trace trace = read_trace_file(file_of(asked));
  require_visits(query, trace);
  asked.options.check = "solver";  // it is the solver that explains, whatever the axioms
  const Theory theory = read_theory(asked, assumptions_of(stated, trace));
  require_countable(query.claim, query.text, theory.axioms);
  const Stop stop = Stop{}.within(asked.options.time_limit_s.value_or(default_explain_s));
  ExplainReport report = explain_query(trace, theory, query, asked.only_minimal, asked.jobs, stop);
  report.options = asked.options;
  if (report.clash)
    report.claim =
        report.modality == Modality::impossible ? one_line(query.text) : contrary_text(query);

  if (write_answer(asked, explanation_json(report, theory.axioms)))
    fmt::print("{}", explanation_text(trace, theory.axioms, report));
  if (command.svg && report.clash)
    write_atomically(*command.svg, explanation_svg(trace, theory.axioms, report));
  else if (command.svg)
    fmt::print(stderr, "nothing clashes: {} is not written\n", *command.svg);
  if (!report.modality) return exit_undecided;
  return *report.modality == Modality::impossible ? exit_inconsistent : exit_consistent;
}

void add_options(CLI::App& explain, ExplainCommand& command) {
  add_maps_of_trace(explain, command.maps);
  add_assumptions(explain, command.maps.assume);
  explain.add_option("query", command.query, "The query, one argument")->required();
  add_over(explain, command.maps, "Ask all maps, or the minimal models alone");
  explain
      .add_option("--json", command.maps.json, "Write the explanation as JSON; -: alone on stdout")
      ->type_name("FILE");
  explain.add_option("--svg", command.svg, "Draw the clash")->type_name("FILE");
  explain
      .add_option("--time-limit", command.maps.options.time_limit_s,
                  "Stop after this many seconds [60]")
      ->type_name("S")
      ->check(seconds);
}

}  // namespace

void add_explain(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "explain",
              "Say why a query is impossible or certain: what clashes, and with what", add_options,
              run, R"(Examples:
  asterism explain examples/aces-stubs.trace.json 'same(8, 10)'
  asterism explain drive.trace.json 'same(3, 9)' --planar --svg clash.svg
  asterism explain drive.trace.json 'places < 7' --over minimal --json - | jq .clash
A clash names visits, axioms and planarity of which none can be spared; a solver that knew nothing of
how it was found has confirmed it. A query that is neither impossible nor certain gets two maps.
docs/queries.md has the grammar.
Exit code: 0 certain or possible, 1 impossible, 2 undecided in the time given, 64 usage or a text that
is no query, 65 bad input or a visit that the trace does not have, 70 internal fault or a result that
cannot be written.)");
}

}  // namespace asterism
