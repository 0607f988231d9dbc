#include "io/json/verification_json.hpp"

#include "io/json/json_writer.hpp"
#include "io/json/trace_file.hpp"

namespace asterism {
namespace {

using Kind = Independence::Kind;

void write_named(JsonWriter& json, const std::vector<std::size_t>& elements,
                 const std::vector<std::string>& names) {
  json.list(elements, [&](JsonWriter& to, std::size_t element) { to.value(names[element]); });
}

void write_function(JsonWriter& json, const AxiomSet::Function& signature,
                    const std::vector<std::vector<std::size_t>>& values, const FiniteModel& model) {
  const auto& results = model.elements.at(signature.result);
  if (signature.arguments.empty()) return write_named(json, values.front(), results);
  const auto& arguments = model.elements.at(signature.arguments.front());
  json.object([&] {
    for (std::size_t argument = 0; argument < values.size(); ++argument)
      write_named(json.key(arguments[argument]), values[argument], results);
  });
}

void write_relation(JsonWriter& json, const AxiomSet::Function& signature,
                    const std::set<std::vector<std::size_t>>& tuples, const FiniteModel& model) {
  json.list(tuples, [&](JsonWriter& to, const std::vector<std::size_t>& tuple) {
    to.array([&] {
      for (std::size_t i = 0; i < tuple.size(); ++i)
        to.value(model.elements.at(signature.arguments[i])[tuple[i]]);
    });
  });
}

void write_model(JsonWriter& json, const FiniteModel& model) {
  json.object([&] {
    json.key("elements").object([&] {
      for (const auto& [sort, names] : model.elements) json.member(sort, names);
    });
    json.key("functions").object([&] {
      for (const auto& [name, values] : model.functions)
        if (!is_own_name(name, model) && !values.empty())
          write_function(json.key(name), model.signature.at(name), values, model);
    });
    json.key("relations").object([&] {
      for (const auto& [name, tuples] : model.relations)
        if (!tuples.empty())
          write_relation(json.key(name), model.signature.at(name), tuples, model);
    });
  });
}

void write_step(JsonWriter& json, const AxiomInstance& step) {
  json.object([&] {
    json.member("axiom", step.axiom);
    json.key("binding").object([&] {
      for (const auto& [variable, term] : step.binding) json.member(variable, term);
    });
  });
}

/// The members that tell whether something is independent, and show it.
/// @param independent, implied  the words for these verdicts
void write_independence(JsonWriter& json, const Independence& independence, const char* independent,
                        const char* implied) {
  json.member("verdict", independence.kind == Kind::independent ? independent
                         : independence.kind == Kind::implied   ? implied
                                                                : "undecided");
  if (independence.model) {
    json.member("fails_at", independence.failure);
    write_model(json.key("model"), *independence.model);
  }
  if (!independence.proof.empty()) json.key("proof").list(independence.proof, write_step);
}

void write_finding(JsonWriter& json, const AxiomFinding& finding) {
  json.object([&] {
    json.member("name", finding.axiom.name, "source", finding.axiom.source, "words",
                finding.axiom.words, "in_force", !finding.is_optional, "by_signature",
                finding.axiom.by_signature);
    write_independence(json, finding.independence, "independent", "implied");
  });
}

/// As in a trace file.
void write_trace(JsonWriter& json, const std::optional<Trace>& trace) {
  trace ? json.value(parse_json(trace_json(*trace), "trace")) : json.null();
}

void write_engines(JsonWriter& json, const EnginesFinding& found) {
  json.object([&] {
    json.member("native_compared", found.is_native, "traces", found.traces, "candidates",
                found.candidates, "maps", found.hypotheses, "maps_counted", found.maps_counted,
                "certified", found.certified, "not_certified", found.not_certified, "cut_short",
                found.cut_short, "difference", found.difference);
    write_trace(json.key("shortest"), found.shortest);
    json.member("remark", found.remark);
  });
}

void write_change(JsonWriter& json, const ChangeFinding& found) {
  json.object([&] {
    json.member("added", found.added, "removed", found.removed, "changed", found.changed,
                "preference_changed", !found.preference.empty(), "traces", found.traces,
                "traces_that_differ", found.traces_that_differ, "cut_short", found.cut_short,
                "maps", found.ours, "shipped_maps", found.shipped, "more", found.gained, "fewer",
                found.lost);
    write_trace(json.key("smallest"), found.smallest);
    json.member("smallest_maps", found.smallest_ours, "smallest_shipped_maps",
                found.smallest_shipped);
  });
}

}  // namespace

std::string verification_json(const VerifyReport& report, std::span<const std::string> faults,
                              std::span<const std::string> undecided) {
  const auto write = [&](JsonWriter& json) {
    json.key("options").object("axioms", report.axioms, "optional_axioms", report.optional_axioms,
                               "worlds", report.worlds, "seed", report.seed, "traces",
                               report.files);
    json.line().key("axioms").lines(report.findings, write_finding);
    // What is independent of all together is that a travel leads from one place to another.
    json.line().key("together").object([&] {
      write_independence(json, report.together, "satisfiable", "unsatisfiable");
    });
    json.line().key("engines");
    report.engines ? write_engines(json, *report.engines) : json.null();
    json.line().key("change");
    report.change ? write_change(json, *report.change) : json.null();
    json.line().member("faults", faults);
    json.line().member("undecided", undecided);
  };
  return json_file("asterism/verification", write, JsonWriter::Style::compact);
}

}  // namespace asterism
