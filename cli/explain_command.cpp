#include <fmt/format.h>

#include <iostream>

#include "cli/explanation_text.hpp"
#include "cli/map_parts.hpp"
#include "cli/query_parts.hpp"
#include "core/deadline.hpp"
#include "engine/query_reader.hpp"
#include "io/atomic_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

/// Why no minimal model makes the claim true, or none makes it false; nothing if some do both.
void explain_by_preference(const ExplainCommand& command, const Trace& trace,
                           const AxiomSet& axioms, ExplainReport& report, Deadline deadline) {
  MapProblem problem(trace, axioms, seconds_until(deadline));
  std::vector<Premise> premises = problem.premises(command.map.options.planar);
  for (const Assumption& assumption : command.map.options.assumptions)
    premises.push_back(problem.add(claim_of(assumption)));
  const auto best_with = [&](const Claim& claim) {
    std::vector<Premise> with_claim = premises;
    with_claim.push_back(problem.add(claim));
    return find_optimum(problem, trace, axioms, std::move(with_claim));
  };
  const Optimum best = find_optimum(problem, trace, axioms, premises);
  const Optimum holding = best_with(report.query.claim);
  const Optimum failing = best_with({Claim::Not{{report.query.claim}}});
  for (const Optimum* optimum : {&best, &holding, &failing})
    if (optimum->verdict != Verdict::consistent) {
      report.modality.reset();
      return;
    }
  report.witness = holding.map;
  report.counterexample = failing.map;
  if (holding.extents == best.extents && failing.extents == best.extents) return;
  const bool is_impossible = holding.extents != best.extents;
  report.modality = is_impossible ? Modality::impossible : Modality::certain;
  report.preference = {best.extents, is_impossible ? holding : failing};
}

void find_reasons(const ExplainCommand& command, const Trace& trace, const AxiomSet& axioms,
                  ExplainReport& report) {
  const Deadline deadline =
      deadline_in(command.map.options.time_limit_s.value_or(default_explain_s));
  const auto reason_of = [&](const Claim& claim) {
    std::vector<Claim> claims;
    for (const Assumption& assumption : command.map.options.assumptions)
      claims.push_back(claim_of(assumption));
    claims.push_back(claim);
    return explain(trace, axioms, command.map.options.planar, claims, seconds_until(deadline));
  };
  Reason holds = reason_of(report.query.claim);
  if (holds.verdict == Verdict::undecided) return;
  if (holds.verdict == Verdict::inconsistent) {
    report.modality = Modality::impossible;
    report.clash = std::move(holds.explanation);
    return;
  }
  Reason fails = reason_of({Claim::Not{{report.query.claim}}});
  if (fails.verdict == Verdict::undecided) return;
  report.witness = whole(holds.map);
  if (fails.verdict == Verdict::inconsistent) {
    report.modality = Modality::certain;
    report.clash = std::move(fails.explanation);
    return;
  }
  report.modality = Modality::possible;
  report.counterexample = whole(fails.map);
  if (command.only_minimal) explain_by_preference(command, trace, axioms, report, deadline);
}

}  // namespace

int explain_command(const ExplainCommand& given) {
  ExplainCommand command = given;
  ExplainReport report{read_query(command.query)};
  const auto stated = read_assumptions(command.map.assume);
  const Trace trace = read_trace_file(command.map.trace == "-" ? "/dev/stdin" : command.map.trace);
  require_visits(report.query, trace);
  command.map.options.assumptions = assumptions_of(stated, trace);
  command.map.options.check = "solver";  // it is the solver that explains, whatever the axioms
  const AxiomSet axioms = read_axioms(command.map);
  require_countable(report.query.claim, report.query.text, axioms);
  find_reasons(command, trace, axioms, report);

  const auto write = [&](std::ostream& out) {
    out << explanation_json(command, trace, axioms, report);
  };
  if (command.map.json == "-") {
    write(std::cout);
  } else {
    if (command.map.json) write_atomically(*command.map.json, write);
    fmt::print("{}", explanation_text(command, trace, axioms, report));
  }
  if (command.svg && report.clash)
    write_atomically(*command.svg, explanation_svg(command, trace, axioms, report));
  else if (command.svg)
    fmt::print(stderr, "nothing clashes: {} is not written\n", *command.svg);
  if (!report.modality) return exit_undecided;
  return *report.modality == Modality::impossible ? exit_inconsistent : exit_consistent;
}

}  // namespace asterism
