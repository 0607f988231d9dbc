#include "io/json/explanation_json.hpp"

#include <algorithm>

#include "io/json/assumption_json.hpp"
#include "io/json/json_writer.hpp"
#include "io/json/map_json.hpp"

namespace asterism {
namespace {

using Kind = Premise::Kind;

void write_whole(JsonWriter& json, const std::vector<Arrival>& map) {
  write_arrivals(json, map.empty() ? std::nullopt : std::optional(map));
}

void write_crossing(JsonWriter& json, const std::optional<Crossing>& crossing) {
  if (!crossing) return json.null();
  json.object("visit", crossing->visit, "left", crossing->left, "entered", crossing->entered,
              "face", crossing->face, "loops", crossing->loops);
}

void write_premise(JsonWriter& json, const Premise& premise, const ExplainReport& report,
                   const AxiomSet& axioms) {
  const std::vector<Assumption>& assumptions = report.options.theory.assumptions;
  switch (premise.kind) {
    case Kind::visit:
      return json.member("visit", premise.number);
    case Kind::axiom: {
      const Axiom& axiom = axioms.axioms()[premise.number];
      return json.member("axiom", axiom.name, "source", axiom.source, "words", axiom.words);
    }
    case Kind::planarity:
      return write_crossing(json.key("planarity"), report.clash->crossing);
    case Kind::claim:
      break;
  }
  if (premise.number < assumptions.size())
    json.member("assumption", text_of(assumptions[premise.number]));
  else
    json.member("claim", report.claim);
}

void write_preference(JsonWriter& json, const std::optional<ExplainReport::Preference>& preference,
                      const AxiomSet& axioms) {
  if (!preference) return json.null();
  json.object([&] {
    json.member("extents", axioms.preference_names(), "minimal", preference->minimal, "best",
                preference->best.extents, "decides",
                axioms.preference_names()[preference->deciding()]);
    write_whole(json.key("map"), preference->best.map);
  });
}

}  // namespace

std::size_t ExplainReport::Preference::deciding() const {
  return static_cast<std::size_t>(std::ranges::mismatch(minimal, best.extents).in1 -
                                  minimal.begin());
}

std::string explanation_json(const ExplainReport& report, const AxiomSet& axioms) {
  const TheoryRecord& theory = report.options.theory;
  const auto write = [&](JsonWriter& json) {
    json.member("trace", report.trace);
    json.key("options").object([&] {
      json.member("planar", theory.planar, "axioms", theory.axioms, "optional_axioms",
                  theory.optional_axioms, "over", report.only_minimal ? "minimal" : "all");
      write_assumptions(json, theory.assumptions);
    });
    json.member("query", report.query.text, "verdict",
                report.modality ? name_of(*report.modality) : "undecided");
    write_preference(json.key("preference"), report.preference, axioms);
    write_whole(json.key("witness"), report.witness);
    write_whole(json.key("counterexample"), report.counterexample);
    if (!report.clash) return json.key("clash").null();
    json.line().key("clash").lines(report.clash->members,
                                   [&](JsonWriter& to, const Clash::Member& member) {
                                     to.object([&] {
                                       write_premise(to, member.premise, report, axioms);
                                       write_arrivals(to.key("without"), member.without);
                                     });
                                   });
  };
  return json_file("asterism/explanation", write, JsonWriter::Style::compact);
}

}  // namespace asterism
