#include "cli/text/explanation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/text/query_text.hpp"
#include "drawing/plane_drawing.hpp"
#include "engine/proof/crossing_map.hpp"
#include "io/picture/clash_svg.hpp"

namespace asterism {
namespace {

using Kind = Premise::Kind;

std::vector<std::size_t> visits_of(const Clash& clash) {
  std::vector<std::size_t> visits;
  for (const auto& [premise, without] : clash.members)
    if (premise.kind == Kind::visit) visits.push_back(premise.number);
  return visits;
}

/// Whether the query is to blame, and not the trace and what is assumed alone.
bool blames_query(const ExplainReport& report) {
  return std::ranges::any_of(report.clash->members, [&](const Clash::Member& member) {
    return member.premise == Premise{Kind::claim, report.options.theory.assumptions.size()};
  });
}

std::string name_of(const Premise& premise, const AxiomSet& axioms, const ExplainReport& report) {
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
  const std::vector<Assumption>& assumptions = report.options.theory.assumptions;
  return premise.number < assumptions.size() ? "assumed " + text_of(assumptions[premise.number])
                                             : report.claim;
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

/// The first visit to a place of a partial map.
std::size_t first_visit(const PartialMap& map, PlaceId place) {
  const auto first = std::ranges::find_if(
      map, [&](const auto& arrival) { return arrival && arrival->place == place; });
  return static_cast<std::size_t>(first - map.begin());
}

/// @param map      that crosses itself
/// @param numbers  the numbers of its places
std::string crossing_text(const Trace& trace, const Crossing& crossing, const PartialMap& map,
                          const PartialMap& numbers) {
  const auto number = [&](PlaceId place) {
    return numbers[first_visit(map, place)]->place.index();
  };
  const auto gateway_text = [&](PlaceArm gateway) {
    const Star& star = trace.visits[first_visit(map, gateway.place)].star;
    return fmt::format("place {} arm {}", number(gateway.place), star.name(gateway.arm));
  };
  std::string text = fmt::format(
      "  planarity       without it the travel to visit {} leaves {} and comes into {}, which is "
      "on\n"
      "                  another face",
      crossing.visit.index(), gateway_text(crossing.left), gateway_text(crossing.entered));
  for (const auto& loop : crossing.loops) {
    std::vector<std::size_t> places;
    for (const PlaceId place : loop) places.push_back(number(place));
    text += fmt::format("; between lies the closed way of places {}", fmt::join(places, " "));
  }
  return text + "\n";
}

std::string clash_text(const Trace& trace, const AxiomSet& axioms, const ExplainReport& report) {
  const Clash& clash = *report.clash;
  std::string text = premises_text(trace, axioms, clash);
  for (const auto& [premise, without] : clash.members)
    if (premise.kind == Kind::claim)
      text += fmt::format("  {}\n", name_of(premise, axioms, report));
  text += "None can be spared. The others allow\n";
  std::size_t width = 27;
  for (const auto& [premise, without] : clash.members)
    width = std::max(width, 8 + name_of(premise, axioms, report).size());
  for (const auto& [premise, without] : clash.members)
    text += fmt::format("  {:<{}} {}\n", "without " + name_of(premise, axioms, report), width,
                        partial_map_text(without));
  return text;
}

/// "6 paths, 9 places".
std::string extents_text(const std::vector<std::size_t>& extents, const AxiomSet& axioms) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < extents.size(); ++i)
    parts.push_back(
        fmt::format("{} {}{}", extents[i], axioms.minimised()[i].name, extents[i] == 1 ? "" : "s"));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string preference_text(const AxiomSet& axioms, const ExplainReport& report) {
  const ExplainReport::Preference& preference = *report.preference;
  const std::size_t level = preference.deciding();
  return fmt::format(
      "The minimal models have {}.\n"
      "The best map where it {} has {}: the preference for fewer {}s decides, by {}.\n"
      "  visits at places {}\n",
      extents_text(preference.minimal, axioms),
      report.modality == Modality::impossible ? "holds" : "fails",
      extents_text(preference.best.extents, axioms), axioms.minimised()[level].name,
      preference.best.extents[level] - preference.minimal[level], visits_text(preference.best.map));
}

/// "same(8, 10): impossible", and what that is due to if not to the query.
std::string title(const ExplainReport& report) {
  const MapOptions& options = report.options;
  const std::string verdict =
      fmt::format("{}: {}", one_line(report.query.text), name_of(*report.modality));
  if (blames_query(report)) return verdict;
  return fmt::format("{}, since no {}map explains the trace{}", verdict,
                     options.theory.planar ? "planar " : "",
                     options.theory.assumptions.empty() ? "" : " under these assumptions");
}

/// The pairs of visits that a claim says were to one place, or to two.
void add_claimed(const Claim& claim, bool is_so, std::vector<ClashPicture::Claimed>& claimed) {
  for (const Statement& statement : statements_of(claim))
    if (const auto* same = std::get_if<Claim::Same>(&statement.claim->is))
      claimed.push_back({same->one, same->other, is_so != statement.is_negated});
}

}  // namespace

std::string premises_text(const Trace& trace, const AxiomSet& axioms, const Clash& clash,
                          const PartialMap& candidate) {
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
      text +=
          crossing_text(trace, *clash.crossing, without, candidate.empty() ? without : candidate);
  }
  return text;
}

std::string explanation_svg(const Trace& trace, const AxiomSet& axioms,
                            const ExplainReport& report) {
  ClashPicture picture;
  picture.title = title(report);
  const std::vector<Assumption>& assumptions = report.options.theory.assumptions;
  for (const auto& [premise, without] : report.clash->members) {
    const std::string name = name_of(premise, axioms, report);
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

std::string explanation_text(const Trace& trace, const AxiomSet& axioms,
                             const ExplainReport& report) {
  const std::string query = one_line(report.query.text);
  if (!report.modality)
    return fmt::format("{}: undecided in {} s\n", query,
                       report.options.time_limit_s.value_or(default_explain_s));
  const std::string assuming = assuming_text(report.options.theory.assumptions);
  if (report.clash)
    return assuming + title(report) + ". These clash:\n" + clash_text(trace, axioms, report);
  if (report.preference)
    return assuming + fmt::format("{}: {} in minimal models. ", query, name_of(*report.modality)) +
           preference_text(axioms, report);
  return assuming + fmt::format(
                        "{}: possible, not certain\n  it holds with visits at places {}\n"
                        "  it fails with visits at places {}\n",
                        query, visits_text(report.witness), visits_text(report.counterexample));
}

}  // namespace asterism
