#include "cli/explanation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/map_parts.hpp"
#include "cli/query_parts.hpp"
#include "engine/crossing_map.hpp"
#include "io/clash_svg.hpp"
#include "planarity/plane_drawing.hpp"

namespace asterism {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Premise::Kind;

std::vector<std::size_t> visits_of(const Explanation& clash) {
  std::vector<std::size_t> visits;
  for (const auto& [premise, without] : clash.members)
    if (premise.kind == Kind::visit) visits.push_back(premise.number);
  return visits;
}

/// Whether the query is to blame, and not the trace and what is assumed alone.
bool blames_query(const ExplainCommand& command, const Explanation& clash) {
  return std::ranges::any_of(clash.members, [&](const Explanation::Member& member) {
    return member.premise == Premise{Kind::claim, command.map.options.assumptions.size()};
  });
}

/// The claim that clashes: the query where it is impossible, its contrary where it is certain.
std::string claim_text(const ExplainReport& report) {
  const std::string query = one_line(report.query.text);
  if (report.modality != Modality::certain) return query;
  const bool is_negation = std::holds_alternative<Claim::Not>(report.query.claim.is);
  return is_negation && query.starts_with("not ") ? query.substr(4) : "not (" + query + ")";
}

std::string name_of(const Premise& premise, const ExplainCommand& command, const AxiomSet& axioms,
                    const ExplainReport& report) {
  switch (premise.kind) {
    case Kind::visit:
      return fmt::format("visit {}", premise.number);
    case Kind::axiom:
      return axioms.axioms()[premise.number].name;
    case Kind::planarity:
      return "planarity";
    case Kind::claim:
      break;
  }
  const std::vector<Assumption>& assumptions = command.map.options.assumptions;
  return premise.number < assumptions.size() ? "assumed " + text_of(assumptions[premise.number])
                                             : claim_text(report);
}

std::string partial_map_text(const PartialMap& map) {
  std::vector<std::size_t> visits;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < map.size(); ++k)
    if (map[k]) {
      visits.push_back(k);
      places.push_back(map[k]->place.index());
    }
  if (visits.empty()) return "anything";
  return fmt::format("visits {} at places {}", fmt::join(visits, " "), fmt::join(places, " "));
}

std::string gateway_text(const Trace& trace, const PartialMap& map, PlaceArm gateway) {
  const auto first = std::ranges::find_if(
      map, [&](const auto& arrival) { return arrival && arrival->place == gateway.place; });
  const Star& star = trace.visits[static_cast<std::size_t>(first - map.begin())].star;
  return fmt::format("place {} arm {}", gateway.place.index(), star.name(gateway.arm));
}

std::string crossing_text(const Trace& trace, const Crossing& crossing, const PartialMap& map) {
  std::string text = fmt::format(
      "  planarity       without it the travel to visit {} leaves {} and comes into {}, which is "
      "on\n"
      "                  another face",
      crossing.visit.index(), gateway_text(trace, map, crossing.left),
      gateway_text(trace, map, crossing.entered));
  for (const auto& loop : crossing.loops) {
    std::vector<std::size_t> places;
    for (const PlaceId place : loop) places.push_back(place.index());
    text += fmt::format("; between lies the closed way of places {}", fmt::join(places, " "));
  }
  return text + "\n";
}

std::string clash_text(const ExplainCommand& command, const Trace& trace, const AxiomSet& axioms,
                       const ExplainReport& report) {
  const Explanation& clash = *report.clash;
  std::string text;
  if (const auto visits = visits_of(clash); !visits.empty())
    text += fmt::format("  visit{}{} {}\n", visits.size() == 1 ? " " : "s", std::string(9, ' '),
                        fmt::join(visits, ", "));
  for (const auto& [premise, without] : clash.members) {
    if (premise.kind == Kind::axiom) {
      const Axiom& axiom = axioms.axioms()[premise.number];
      text += fmt::format("  {:<15} {} {}\n", axiom.name, axiom.words, axiom.source);
    }
    if (clash.crossing && premise.kind == Kind::planarity)
      text += crossing_text(trace, *clash.crossing, without);
    if (premise.kind == Kind::claim)
      text += fmt::format("  {}\n", name_of(premise, command, axioms, report));
  }
  text += "None can be spared. The others allow\n";
  std::size_t width = 27;
  for (const auto& [premise, without] : clash.members)
    width = std::max(width, 8 + name_of(premise, command, axioms, report).size());
  for (const auto& [premise, without] : clash.members)
    text += fmt::format("  {:<{}} {}\n", "without " + name_of(premise, command, axioms, report),
                        width, partial_map_text(without));
  return text;
}

/// "6 paths, 9 places".
std::string extents_text(const std::vector<std::size_t>& extents, const AxiomSet& axioms) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < extents.size(); ++i)
    parts.push_back(
        fmt::format("{} {}{}", extents[i], axioms.preference()[i], extents[i] == 1 ? "" : "s"));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::size_t deciding(const ExplainReport::Preference& preference) {
  return static_cast<std::size_t>(
      std::ranges::mismatch(preference.minimal, preference.best.extents).in1 -
      preference.minimal.begin());
}

std::string preference_text(const AxiomSet& axioms, const ExplainReport& report) {
  const ExplainReport::Preference& preference = *report.preference;
  const std::size_t level = deciding(preference);
  return fmt::format(
      "The minimal models have {}.\n"
      "The best map where it {} has {}: the preference for fewer {}s decides, by {}.\n"
      "  visits at places {}\n",
      extents_text(preference.minimal, axioms),
      report.modality == Modality::impossible ? "holds" : "fails",
      extents_text(preference.best.extents, axioms), axioms.preference()[level],
      preference.best.extents[level] - preference.minimal[level], visits_text(preference.best.map));
}

Json json_of(const PartialMap& map) {
  Json visits = Json::array();
  Json entered = Json::array();
  for (const auto& arrival : map) {
    visits.push_back(arrival ? Json(arrival->place.index()) : Json());
    entered.push_back(arrival && arrival->entered ? Json(*arrival->entered) : Json());
  }
  return {{"visits", visits}, {"entered", entered}};
}

Json json_of(const std::vector<Arrival>& map) {
  return map.empty() ? Json() : json_of(PartialMap(map.begin(), map.end()));
}

Json json_of(PlaceArm gateway) { return {gateway.place.index(), gateway.arm}; }

Json json_of(const Crossing& crossing) {
  Json face = Json::array();
  for (const PlaceArm gateway : crossing.face) face.push_back(json_of(gateway));
  Json loops = Json::array();
  for (const auto& loop : crossing.loops) {
    loops.push_back(Json::array());
    for (const PlaceId place : loop) loops.back().push_back(place.index());
  }
  return {{"visit", crossing.visit.index()},
          {"left", json_of(crossing.left)},
          {"entered", json_of(crossing.entered)},
          {"face", face},
          {"loops", loops}};
}

Json json_of(const Explanation::Member& member, const ExplainCommand& command,
             const AxiomSet& axioms, const ExplainReport& report) {
  const Explanation& clash = *report.clash;
  const std::vector<Assumption>& assumptions = command.map.options.assumptions;
  Json json;
  switch (member.premise.kind) {
    case Kind::visit:
      json["visit"] = member.premise.number;
      break;
    case Kind::axiom: {
      const Axiom& axiom = axioms.axioms()[member.premise.number];
      json = {{"axiom", axiom.name}, {"source", axiom.source}, {"words", axiom.words}};
      break;
    }
    case Kind::planarity:
      json["planarity"] = clash.crossing ? json_of(*clash.crossing) : Json();
      break;
    case Kind::claim:
      if (member.premise.number < assumptions.size())
        json["assumption"] = text_of(assumptions[member.premise.number]);
      else
        json["claim"] = claim_text(report);
      break;
  }
  json["without"] = json_of(member.without);
  return json;
}

/// "same(8, 10): impossible", and what that is due to if not to the query.
std::string title(const ExplainCommand& command, const ExplainReport& report) {
  const MapOptions& options = command.map.options;
  const std::string verdict =
      fmt::format("{}: {}", one_line(report.query.text), name_of(*report.modality));
  if (blames_query(command, *report.clash)) return verdict;
  return fmt::format("{}, since no {}map explains the trace{}", verdict,
                     options.planar ? "planar " : "",
                     options.assumptions.empty() ? "" : " under these assumptions");
}

/// The pairs of visits that a claim says were to one place, or to two.
void add_claimed(const Claim& claim, bool is_so, std::vector<ClashPicture::Claimed>& claimed) {
  if (const auto* all = std::get_if<Claim::All>(&claim.is))
    for (const Claim& part : all->parts) add_claimed(part, is_so, claimed);
  if (const auto* any = std::get_if<Claim::Any>(&claim.is))
    for (const Claim& part : any->parts) add_claimed(part, is_so, claimed);
  if (const auto* negation = std::get_if<Claim::Not>(&claim.is))
    add_claimed(negation->part.front(), !is_so, claimed);
  if (const auto* same = std::get_if<Claim::Same>(&claim.is))
    claimed.push_back({same->one, same->other, is_so});
}

}  // namespace

std::string explanation_svg(const ExplainCommand& command, const Trace& trace,
                            const AxiomSet& axioms, const ExplainReport& report) {
  ClashPicture picture;
  picture.title = title(command, report);
  const std::vector<Assumption>& assumptions = command.map.options.assumptions;
  for (const auto& [premise, without] : report.clash->members) {
    const std::string name = name_of(premise, command, axioms, report);
    picture.without.push_back({"without " + name, partial_map_text(without)});
    switch (premise.kind) {
      case Kind::visit:
        picture.visits.push_back(VisitId(premise.number));
        continue;
      case Kind::axiom: {
        const Axiom& axiom = axioms.axioms()[premise.number];
        picture.said.push_back({name, axiom.words + " " + axiom.source});
        continue;
      }
      case Kind::planarity:
        picture.said.push_back({name, "The map can be drawn in the plane."});
        if (report.clash->crossing) {
          const CrossingMap crossing = crossing_map(trace, without, *report.clash->crossing);
          picture.crossing = {crossing.map,    draw(crossing.map), report.clash->crossing->visit,
                              crossing.visits, crossing.names,     crossing.loops};
        }
        continue;
      case Kind::claim:
        break;
    }
    picture.said.push_back({name, ""});
    if (premise.number < assumptions.size())
      add_claimed(claim_of(assumptions[premise.number]), true, picture.claimed);
    else
      add_claimed(report.query.claim, report.modality == Modality::impossible, picture.claimed);
  }
  return clash_svg(trace, picture);
}

std::string explanation_text(const ExplainCommand& command, const Trace& trace,
                             const AxiomSet& axioms, const ExplainReport& report) {
  const std::string query = one_line(report.query.text);
  if (!report.modality)
    return fmt::format("{}: undecided in {} s\n", query,
                       command.map.options.time_limit_s.value_or(default_explain_s));
  const std::string assuming = assuming_text(command.map.options.assumptions);
  if (report.clash)
    return assuming + title(command, report) + ". These clash:\n" +
           clash_text(command, trace, axioms, report);
  if (report.preference)
    return assuming + fmt::format("{}: {} in minimal models. ", query, name_of(*report.modality)) +
           preference_text(axioms, report);
  return assuming + fmt::format(
                        "{}: possible, not certain\n  it holds with visits at places {}\n"
                        "  it fails with visits at places {}\n",
                        query, visits_text(report.witness), visits_text(report.counterexample));
}

std::string explanation_json(const ExplainCommand& command, const Trace& trace,
                             const AxiomSet& axioms, const ExplainReport& report) {
  const MapOptions& options = command.map.options;
  Json json{{"format", "asterism/explanation"}, {"version", 1}, {"trace", trace.name}};
  json["options"] = {{"planar", options.planar},
                     {"axioms", options.axioms},
                     {"optional_axioms", options.optional_axioms},
                     {"over", command.only_minimal ? "minimal" : "all"}};
  for (const Assumption& assumption : options.assumptions)
    json["options"]["assumptions"].push_back(text_of(assumption));
  json["query"] = report.query.text;
  json["verdict"] = report.modality ? name_of(*report.modality) : "undecided";
  json["preference"] = nullptr;
  if (report.preference)
    json["preference"] = {{"extents", axioms.preference()},
                          {"minimal", report.preference->minimal},
                          {"best", report.preference->best.extents},
                          {"decides", axioms.preference()[deciding(*report.preference)]},
                          {"map", json_of(report.preference->best.map)}};
  json["witness"] = json_of(report.witness);
  json["counterexample"] = json_of(report.counterexample);
  const std::string head = json.dump();
  if (!report.clash) return head.substr(0, head.size() - 1) + ",\"clash\":null}\n";
  std::vector<std::string> members;  // one a line
  for (const Explanation::Member& member : report.clash->members)
    members.push_back(json_of(member, command, axioms, report).dump());
  return fmt::format("{},\n  \"clash\": [\n    {}]}}\n", head.substr(0, head.size() - 1),
                     fmt::join(members, ",\n    "));
}

}  // namespace asterism
