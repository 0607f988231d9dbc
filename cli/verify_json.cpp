#include <nlohmann/json.hpp>

#include "cli/verify_text.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Independence::Kind;

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::independent:
      return "independent";
    case Kind::implied:
      return "implied";
    case Kind::undecided:
      break;
  }
  return "undecided";
}

Json json_of(const FiniteModel& model) {
  Json functions = Json::object();
  for (const auto& [name, values] : model.functions) {
    if (is_own_name(name, model)) continue;
    const AxiomSet::Function& signature = model.signature.at(name);
    const auto& results = model.elements.at(signature.result);
    for (std::size_t argument = 0; argument < values.size(); ++argument) {
      Json all = Json::array();
      for (const std::size_t value : values[argument]) all.push_back(results[value]);
      if (signature.arguments.empty())
        functions[name] = all;
      else
        functions[name][model.elements.at(signature.arguments.front())[argument]] = all;
    }
  }
  Json relations = Json::object();
  for (const auto& [name, tuples] : model.relations)
    for (const auto& tuple : tuples) {
      Json named = Json::array();
      for (std::size_t i = 0; i < tuple.size(); ++i)
        named.push_back(model.elements.at(model.signature.at(name).arguments[i])[tuple[i]]);
      relations[name].push_back(named);
    }
  return {{"elements", model.elements}, {"functions", functions}, {"relations", relations}};
}

Json json_of(const Independence& independence) {
  Json result{{"verdict", name_of(independence.kind)}};
  if (independence.model) {
    result["fails_at"] = independence.failure;
    result["model"] = json_of(*independence.model);
  }
  for (const Clash::Step& step : independence.proof) {
    Json binding = Json::object();
    for (const auto& [variable, term] : step.binding) binding[variable] = term;
    result["proof"].push_back({{"axiom", step.axiom}, {"binding", binding}});
  }
  return result;
}

Json json_of(const AxiomFinding& finding) {
  Json result{{"name", finding.axiom.name},
              {"source", finding.axiom.source},
              {"words", finding.axiom.words},
              {"in_force", !finding.is_optional},
              {"by_signature", finding.axiom.by_signature}};
  result.update(json_of(finding.independence));
  return result;
}

/// As in a trace file.
Json json_of(const std::optional<Trace>& trace) {
  return trace ? Json::parse(trace_json(*trace)) : Json();
}

Json json_of(const EnginesFinding& found) {
  return {{"native_compared", found.is_native},
          {"traces", found.traces},
          {"candidates", found.candidates},
          {"maps", found.hypotheses},
          {"maps_counted", found.maps_counted},
          {"certified", found.certified},
          {"not_certified", found.not_certified},
          {"cut_short", found.cut_short},
          {"difference", found.difference ? Json(*found.difference) : Json()},
          {"shortest", json_of(found.shortest)},
          {"remark", found.remark ? Json(*found.remark) : Json()}};
}

Json json_of(const ChangeFinding& found) {
  return {{"added", found.added},
          {"removed", found.removed},
          {"changed", found.changed},
          {"preference_changed", !found.preference.empty()},
          {"traces", found.traces},
          {"traces_that_differ", found.traces_that_differ},
          {"cut_short", found.cut_short},
          {"maps", found.ours},
          {"shipped_maps", found.shipped},
          {"more", found.gained},
          {"fewer", found.lost},
          {"smallest", json_of(found.smallest)},
          {"smallest_maps", found.smallest_ours},
          {"smallest_shipped_maps", found.smallest_shipped}};
}

}  // namespace

std::string verify_json(const VerifyReport& report) {
  const Json head{{"format", "asterism/verification"},
                  {"version", 1},
                  {"options",
                   {{"axioms", report.axioms},
                    {"optional_axioms", report.optional_axioms},
                    {"worlds", report.worlds},
                    {"seed", report.seed},
                    {"traces", report.files}}}};
  // An axiom a line.
  std::string text = head.dump();
  text.pop_back();
  text += ",\n  \"axioms\": [";
  for (const AxiomFinding& finding : report.findings)
    text += (text.ends_with('[') ? "\n    " : ",\n    ") + json_of(finding).dump();
  text += "]";
  const auto add = [&](const std::string& key, const Json& value) {
    text += ",\n  \"" + key + "\": " + value.dump();
  };
  Json together = json_of(report.together);
  together["verdict"] = report.together.kind == Kind::independent ? "satisfiable"
                        : report.together.kind == Kind::implied   ? "unsatisfiable"
                                                                  : "undecided";
  add("together", together);
  add("engines", report.engines ? json_of(*report.engines) : Json());
  add("change", report.change ? json_of(*report.change) : Json());
  add("faults", faults_of(report));
  add("undecided", undecided_of(report));
  return text + "}\n";
}

}  // namespace asterism
