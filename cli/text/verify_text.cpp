#include "cli/text/verify_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/json/trace_file.hpp"

namespace asterism {
namespace {

using Kind = Independence::Kind;

std::string plural(std::uint64_t count, const std::string& noun) {
  const std::string many = noun.ends_with('s') ? noun : noun + "s";
  return fmt::format("{} {}", count, count == 1 ? noun : many);
}

std::string proof_text(const std::vector<AxiomInstance>& proof) {
  std::vector<std::string> steps;
  for (const AxiomInstance& step : proof) steps.push_back(instance_text(step));
  return fmt::format("    {}\n", fmt::join(steps, ", "));
}

/// "q = q0, r = q1"
std::string failure_text(const Axiom& axiom, const std::vector<std::string>& failure) {
  std::vector<std::string> bindings;
  for (std::size_t i = 0; i < failure.size(); ++i)
    bindings.push_back(axiom.variables[i].name + " = " + failure[i]);
  return fmt::format("{}", fmt::join(bindings, ", "));
}

/// What was found of an axiom that the signature says.
std::string signature_text(const AxiomFinding& finding) {
  std::string text =
      fmt::format("  said by the signature: {} is declared so that nothing else can be\n",
                  finding.axiom.function);
  if (finding.independence.kind == Kind::independent)
    text += fmt::format(
        "  independent where {} is read as a relation: it alone fails, of two values at {}\n    "
        "{}\n",
        finding.axiom.function, finding.independence.failure.front(),
        model_text(*finding.independence.model));
  return text;
}

std::string verdict_text(const AxiomFinding& finding) {
  const std::string put_in = finding.is_optional ? "off; put to those that are on: " : "";
  switch (finding.independence.kind) {
    case Kind::independent:
      return fmt::format("  {}independent: it alone fails, at {}\n    {}\n", put_in,
                         failure_text(finding.axiom, finding.independence.failure),
                         model_text(*finding.independence.model));
    case Kind::implied:
      if (finding.independence.proof.empty())
        return fmt::format("  {}implied: it cannot fail, whatever holds\n", put_in);
      return fmt::format("  {}implied: where it fails, these cannot all hold\n{}", put_in,
                         proof_text(finding.independence.proof));
    case Kind::undecided:
      break;
  }
  return fmt::format("  {}undecided: neither a model nor a proof was found\n", put_in);
}

std::string finding_text(const AxiomFinding& finding) {
  const Axiom& axiom = finding.axiom;
  std::string text = axiom.name + (axiom.source.empty() ? "" : "  ") + axiom.source + "\n";
  if (!axiom.words.empty()) text += "  " + axiom.words + "\n";
  if (!axiom.formula.empty()) text += "  " + axiom.formula + "\n";
  return text + (axiom.by_signature ? signature_text(finding) : verdict_text(finding)) + "\n";
}

std::string together_text(const Independence& together) {
  switch (together.kind) {
    case Kind::independent:
      return fmt::format("  satisfiable: travel leads from {} to {}, at another place\n    {}\n\n",
                         together.failure[0], together.failure[1], model_text(*together.model));
    case Kind::implied:
      return "  unsatisfiable: where travel leads from q to r, at another place, these cannot all "
             "hold\n" +
             proof_text(together.proof) + "\n";
    case Kind::undecided:
      break;
  }
  return "  undecided: neither a model nor a proof was found\n\n";
}

std::string engines_text(const VerifyReport& report) {
  const EnginesFinding& found = *report.engines;
  std::string text =
      "on " + plural(report.worlds, "random world") + fmt::format(" from seed {}", report.seed);
  if (!report.files.empty()) text += " and " + plural(report.files.size(), "trace");
  text += ", all maps and planar ones\n";
  if (found.is_native)
    text += fmt::format("  native engine and solver {} at {}; {} left\n",
                        found.difference ? "compared" : "equal",
                        plural(found.candidates, "candidate"), plural(found.hypotheses, "map"));
  else
    text += fmt::format(
        "  decided by the solver, since the native engine does not know them; {} "
        "left\n",
        plural(found.hypotheses, "map"));
  text += fmt::format("  paths, places and segments counted as the axioms force them: {}\n",
                      plural(found.maps_counted, "map"));
  text += "  minimal models certified: " + plural(found.certified, "time");
  if (found.not_certified > 0)
    text += fmt::format(", {} not in time", plural(found.not_certified, "time"));
  text += "\n";
  if (found.cut_short > 0)
    text += fmt::format("  left out, for too many maps: {}\n", plural(found.cut_short, "time"));
  if (found.remark) text += "  remark: " + *found.remark + "\n";
  if (found.difference) text += "  different: " + *found.difference + "\n";
  if (found.shortest) text += trace_json(*found.shortest);
  return text + "\n";
}

std::string change_text(const ChangeFinding& found) {
  std::string text = "against the shipped axioms\n";
  const auto add_names = [&](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) text += fmt::format("  {}: {}\n", what, fmt::join(names, ", "));
  };
  add_names("added", found.added);
  add_names("removed", found.removed);
  add_names("changed", found.changed);
  if (found.added.empty() && found.removed.empty() && found.changed.empty())
    text += "  the same axioms\n";
  if (!found.preference.empty())
    text += fmt::format("  preferred by {}, not by {}\n", fmt::join(found.preference, ", "),
                        fmt::join(found.shipped_preference, ", "));
  text += fmt::format("  {}: {}, and {} by the shipped axioms; {} more, {} fewer\n",
                      plural(found.traces, "trace"), plural(found.ours, "map"), found.shipped,
                      found.gained, found.lost);
  if (found.cut_short > 0)
    text += fmt::format("  compared only until there were too many maps: {}\n",
                        plural(found.cut_short, "trace"));
  if (found.smallest)
    text += fmt::format(
        "  {} in what they leave; least, {}, and {} by the shipped axioms:\n{}",
        found.traces_that_differ == 1 ? "1 trace differs"
                                      : fmt::format("{} traces differ", found.traces_that_differ),
        plural(found.smallest_ours, "map"), found.smallest_shipped, trace_json(*found.smallest));
  return text + "\n";
}

/// Axioms of this kind, by name.
std::vector<std::string> names_of(const VerifyReport& report, Kind kind) {
  std::vector<std::string> result;
  for (const AxiomFinding& finding : report.findings)
    if (finding.independence.kind == kind && !finding.axiom.by_signature)
      result.push_back(finding.axiom.name);
  return result;
}

}  // namespace

std::vector<std::string> faults_of(const VerifyReport& report) {
  std::vector<std::string> result;
  if (report.together.kind == Kind::implied)
    result.push_back("the axioms allow no travel from one place to another");
  if (report.engines && report.engines->difference) result.push_back(*report.engines->difference);
  return result;
}

std::vector<std::string> undecided_of(const VerifyReport& report) {
  std::vector<std::string> result;
  for (const std::string& name : names_of(report, Kind::undecided))
    result.push_back("whether the others imply " + name);
  if (report.together.kind == Kind::undecided)
    result.push_back("whether the axioms are satisfiable with a travel");
  if (report.engines && report.engines->not_certified > 0)
    result.push_back("whether some minimal models are minimal");
  if (report.engines && report.engines->is_native && report.engines->cut_short > 0)
    result.push_back("traces left out for too many maps: " +
                     plural(report.engines->cut_short, "time"));
  if (report.engines && report.engines->stopped_by)
    result.push_back("the rest of the traces: stopped by " + *report.engines->stopped_by);
  if (report.change && report.change->stopped_by)
    result.push_back("the rest of what changes: stopped by " + *report.change->stopped_by);
  return result;
}

std::string verify_text(const VerifyReport& report) {
  std::string text;
  for (const AxiomFinding& finding : report.findings) text += finding_text(finding);
  text += "all of them" + std::string(report.optional_axioms.empty() ? "" : ", with ") +
          fmt::format("{}\n", fmt::join(report.optional_axioms, ", ")) +
          together_text(report.together);
  if (report.engines) text += engines_text(report);
  if (report.change) text += change_text(*report.change);
  const std::vector<std::string> faults = faults_of(report);
  const std::vector<std::string> undecided = undecided_of(report);
  for (const std::string& fault : faults) text += "fault: " + fault + "\n";
  for (const std::string& question : undecided) text += "undecided: " + question + "\n";
  for (const std::string& name : names_of(report, Kind::implied))
    text += "remark: " + name + " is implied\n";
  if (faults.empty() && undecided.empty()) text += "all is well\n";
  return text;
}

}  // namespace asterism
