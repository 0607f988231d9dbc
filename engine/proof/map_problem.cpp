#include "engine/proof/map_problem.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "axioms/bench/lazy_grounding.hpp"
#include "axioms/bench/spare.hpp"
#include "axioms/bench/z3.hpp"
#include "engine/ask/query_map.hpp"
#include "engine/facts.hpp"
#include "engine/proof/claim_circuit.hpp"
#include "engine/proof/free_association.hpp"
#include "planarity/euler.hpp"

namespace asterism {
namespace {

/// Whether a map without some visits says the same of it: what it says of which visits were to one
/// place stays, and so does what it says of visits that are left out, since that is free.
bool is_about_places(const Claim& claim) {
  return std::ranges::all_of(statements_of(claim), [](const Statement& statement) {
    return std::holds_alternative<Claim::Same>(statement.claim->is);
  });
}

}  // namespace

class MapProblem::State {
 public:
  State(const Trace& trace, const Theory& theory, Deadline deadline,
        std::span<const Arrival> candidate)
      : deadline_(deadline),
        is_planar_(theory.planar),
        table_(trace, candidate.empty() ? trace.visits.size() : candidate.size()),
        candidate_(table_.named(candidate)),
        solver_(simple_solver(context_)),
        association_(context_, solver_, table_),
        circuit_(association_, solver_),
        planarity_(context_.bool_const("planarity")),
        axioms_(literals(theory.axioms)),
        grounding_(theory.axioms, context_, solver_, axioms_),
        is_shipped_(theory.axioms.is_shipped()) {
    set_parameter(solver_, "relevancy", 0U);  // what is told says what is relevant: half the time
    grounding_.add(general_facts(), context_.bool_val(true));
    for (const Assumption& assumption : theory.assumptions)
      assumed_.push_back(add(claim_of(assumption)));
  }

  Premise add(const Claim& claim) {
    const std::string name = "claim_" + std::to_string(claims_.size());
    claims_.push_back({claim, context_.bool_const(name.c_str())});
    solver_.add(z3::implies(claims_.back().literal, circuit_.formula(claim)));
    return {Premise::Kind::claim, claims_.size() - 1};
  }

  Premise exclude(std::span<const Arrival> map) {
    const Premise premise = add({Claim::All{}});
    solver_.add(z3::implies(literal(premise), !is_map(table_.named(map))));
    return premise;
  }

  std::vector<Premise> premises() const {
    std::vector<Premise> result;
    for (std::size_t k = 0; k < table_.visits(); ++k) result.push_back({Premise::Kind::visit, k});
    const std::vector<Axiom>& axioms = grounding_.axioms().axioms();
    for (std::size_t i = 0; i < axioms.size(); ++i)
      if (!axioms[i].by_signature) result.push_back({Premise::Kind::axiom, i});
    if (is_planar_) result.push_back({Premise::Kind::planarity});
    result.insert(result.end(), assumed_.begin(), assumed_.end());
    return result;
  }

  Verdict check(std::span<const Premise> premises) {
    const std::set<Premise> given(premises.begin(), premises.end());
    std::set<Premise> in_force;
    std::ranges::copy_if(given, std::inserter(in_force, in_force.end()),
                         [&](const Premise& premise) { return given.contains(based_on(premise)); });
    const bool all_about_places = std::ranges::all_of(in_force, [&](const Premise& premise) {
      return premise.kind != Premise::Kind::claim || is_about_places(claims_[premise.number].claim);
    });
    if (all_about_places && is_shipped_ && has_all_axioms(in_force))
      for (const auto& part : parts_of(in_force))
        if (check(part, true) == Verdict::inconsistent) return Verdict::inconsistent;
    const Verdict without = check(in_force, true);
    // What a map says of visits left open may make other claims true.
    const bool may_say_more = !all_about_places && leaves_visits_open(in_force);
    return without == Verdict::inconsistent && may_say_more ? check(in_force, false) : without;
  }

  std::span<const Premise> core() const { return core_; }

  PartialMap map() const {
    PartialMap result(named_.size());
    std::map<VisitId, PlaceId> places;  // by first visit
    for (std::size_t k = 0; k < named_.size(); ++k) {
      if (named_[k] == no_arm) continue;
      const VisitId first = table_.visit_of(named_[k]);
      const PlaceId place = places.try_emplace(first, places.size()).first->second;
      result[k] = Arrival{place, table_.position(named_[k])};
    }
    if (result.front() && !table_.trace().visits.front().entered_by)
      result.front()->entered = std::nullopt;
    return result;
  }

 private:
  struct AddedClaim {
    Claim claim;
    z3::expr literal;
  };

  std::vector<z3::expr> literals(const AxiomSet& axioms) {
    std::vector<z3::expr> result;
    for (const Axiom& axiom : axioms.axioms())
      result.push_back(context_.bool_const(("axiom_" + axiom.name).c_str()));
    return result;
  }

  bool leaves_visits_open(const std::set<Premise>& in_force) const {
    for (std::size_t k = 0; k < table_.visits(); ++k)
      if (!in_force.contains({Premise::Kind::visit, k})) return true;
    return false;
  }

  bool has_all_axioms(const std::set<Premise>& in_force) const {
    const std::vector<Axiom>& axioms = grounding_.axioms().axioms();
    for (std::size_t i = 0; i < axioms.size(); ++i)
      if (!axioms[i].by_signature && !in_force.contains({Premise::Kind::axiom, i})) return false;
    return true;
  }

  /// Premises with fewer visits, round those that claims are about. The visits of a map that are
  /// left make a map, since all that were to one place saw one star: so if these cannot be, nor can
  /// all, and they are sooner decided.
  /// @pre  all claims are about places
  std::vector<std::set<Premise>> parts_of(const std::set<Premise>& in_force) const {
    std::set<std::size_t> named;
    for (const Premise& premise : in_force)
      if (premise.kind == Premise::Kind::claim)
        for (const Statement& statement : statements_of(claims_[premise.number].claim)) {
          const auto& [one, other] = std::get<Claim::Same>(statement.claim->is);
          named.insert({one.index(), other.index()});
        }
    if (named.empty()) return {};
    const auto part = [&](const auto& is_kept) {
      std::set<Premise> kept = in_force;
      std::erase_if(kept, [&](const Premise& premise) {
        return premise.kind == Premise::Kind::visit && !is_kept(premise.number);
      });
      return kept;
    };
    const auto near = [&](std::size_t k) {
      return std::ranges::any_of(named, [&](std::size_t i) { return i <= k + 1 && k <= i + 1; });
    };
    const auto between = [&](std::size_t k) { return *named.begin() <= k && k <= *named.rbegin(); };
    std::vector<std::set<Premise>> parts{part([&](std::size_t k) { return named.contains(k); }),
                                         part(near), part(between)};
    std::erase_if(parts, [&](const auto& fewer) { return fewer.size() + 5 > in_force.size(); });
    return parts;
  }

  Verdict check(const std::set<Premise>& in_force, bool nothing_else_told) {
    z3::expr_vector assumptions(context_);
    std::map<unsigned, Premise> premise_of;
    for (const Premise& premise : in_force) {
      assumptions.push_back(literal(premise));
      premise_of.emplace(literal(premise).id(), premise);
    }
    for (const VisitId k : table_.all_visits())
      if (nothing_else_told && !in_force.contains({Premise::Kind::visit, k.index()}))
        assumptions.push_back(!association_.told(k));
      else
        prepare(k);
    const Verdict verdict = grounding_.solve(assumptions, deadline_, [&] {
      named_ = association_.named(solver_.get_model());
      return refute(in_force) || rule_out_crossing(in_force) || rule_out_miscounted(in_force);
    });
    if (verdict != Verdict::inconsistent) return verdict;
    std::set<Premise> core;
    for (const z3::expr& used : solver_.unsat_core())
      if (const auto of = premise_of.find(used.id()); of != premise_of.end())
        core.insert({of->second, based_on(of->second)});
    core_.assign(core.begin(), core.end());
    return verdict;
  }

  bool out_of_time() const { return is_over(deadline_); }

  /// What holds wherever a visit that is told of was. Cut short, it is not asked: check() finds
  /// itself out of time as well.
  void prepare(VisitId k) {
    if (!prepared_.insert(k).second) return;
    association_.choose(k);
    grounding_.add(place_facts(table_, k), association_.is_new(k));
    for (const VisitId j : prepared_) {
      if (out_of_time()) return;
      const auto [place, visit] = std::minmax(j, k);
      for (const ArmId arm : table_.arms(place))
        if (place != visit || arm == table_.entered(visit)) {
          const auto facts = travel_facts(table_, visit, arm, arm);
          const auto sees = std::span(facts).first(1);
          grounding_.add(sees, association_.at(visit, arm));
        }
    }
  }

  /// Of a visit of a candidate, the first to its place, without which it is not said where it was.
  Premise based_on(const Premise& premise) const {
    if (premise.kind != Premise::Kind::visit || candidate_.empty()) return premise;
    return {Premise::Kind::visit, table_.visit_of(candidate_[premise.number]).index()};
  }

  z3::expr literal(const Premise& premise) const {
    switch (premise.kind) {
      case Premise::Kind::visit: {
        const VisitId k(premise.number);
        return candidate_.empty() ? association_.told(k)
                                  : association_.at(k, candidate_[k.index()]);
      }
      case Premise::Kind::axiom:
        return axioms_.at(premise.number);
      case Premise::Kind::claim:
        return claims_.at(premise.number).literal;
      case Premise::Kind::planarity:
        break;
    }
    return planarity_;
  }

  /// Every visit was where it is named.
  z3::expr is_map(std::span<const ArmId> named) {
    z3::expr_vector choices(context_);
    for (const VisitId k : table_.all_visits())
      choices.push_back(association_.at(k, named[k.index()]));
    return z3::mk_and(choices);
  }

  bool is_told(VisitId k) const { return named_[k.index()] != no_arm; }

  /// Grounds the axioms on this map. Nothing new to say means that it satisfies those in force.
  bool refute(const std::set<Premise>& in_force) {
    std::vector<LazyGrounding::FoundFact> travels;
    for (const VisitId k : IdRange(VisitId(1), VisitId(named_.size()))) {
      const VisitId before = k.previous();
      if (!is_told(before) || !is_told(k)) continue;
      const ArmId from = named_[before.index()];
      const ArmId to = named_[k.index()];
      const auto facts = travel_facts(table_, k, table_.left(before, from), to);
      for (const Fact& fact : std::span(facts).subspan(1))
        travels.push_back({fact, association_.at(before, from), association_.at(k, to)});
    }
    return grounding_.refutes(travels, deadline_, [&](std::size_t axiom) {
      return in_force.contains({Premise::Kind::axiom, axiom});
    });
  }

  bool rule_out_crossing(const std::set<Premise>& in_force) {
    if (!in_force.contains({Premise::Kind::planarity})) return false;
    auto part = part_not_planar(sketch_of(table_.trace(), map()).map);
    if (!part) return false;
    TopologicalMap sketch = *std::move(part);
    using Segments = std::vector<TopologicalMap::Segment>;
    const Segments fewest =
        spare_one_by_one(sketch.segments, sketch.segments, [&](const Segments& others) {
          sketch.segments = others;
          return is_planar(sketch) ? std::nullopt : std::optional(others);
        });
    z3::expr_vector segments(context_);
    for (const auto& [one, other] : fewest) {
      const auto arm = [&](const PlaceArm& gateway) {
        const VisitId first = sketch.places[gateway.place.index()].first_visit;
        return table_.arm(first, gateway.arm);
      };
      segments.push_back(association_.linked(arm(one), arm(other)));
    }
    solver_.add(z3::implies(planarity_, !z3::mk_and(segments)));
    return true;
  }

  /// The closed form counts a path that closes on itself as none, where axioms allow it.
  bool rule_out_miscounted(const std::set<Premise>& in_force) {
    if (std::ranges::count(named_, no_arm) > 0) return false;
    const std::vector<Arrival> arrivals = table_.arrivals(named_);
    QueryMap map(table_.trace());
    map.set(arrivals);
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      if (!in_force.contains({Premise::Kind::claim, i}) || holds(claims_[i].claim, map)) continue;
      solver_.add(!is_map(named_) || !claims_[i].literal);
      return true;
    }
    return false;
  }

  Deadline deadline_;
  bool is_planar_;
  ArmTable table_;
  std::vector<ArmId> candidate_;  ///< the arm each visit came in by; empty: the solver finds out
  z3::context context_;
  z3::solver solver_;
  FreeAssociation association_;
  ClaimCircuit circuit_;
  z3::expr planarity_;
  std::vector<z3::expr> axioms_;  ///< one literal each
  LazyGrounding grounding_;
  bool is_shipped_;
  std::vector<AddedClaim> claims_;
  std::vector<Premise> assumed_;

  std::set<VisitId> prepared_;

  std::vector<Premise> core_;
  std::vector<ArmId> named_;
};

MapProblem::MapProblem(const Trace& trace, const Theory& theory, const Stop& stop,
                       std::span<const Arrival> candidate) {
  state_ =
      guarded_z3([&] { return std::make_unique<State>(trace, theory, stop.deadline, candidate); });
}
MapProblem::~MapProblem() = default;
MapProblem::MapProblem(MapProblem&&) noexcept = default;
MapProblem& MapProblem::operator=(MapProblem&&) noexcept = default;

Premise MapProblem::add(const Claim& claim) {
  return guarded_z3([&] { return state_->add(claim); });
}

Premise MapProblem::exclude(std::span<const Arrival> map) {
  return guarded_z3([&] { return state_->exclude(map); });
}

std::vector<Premise> MapProblem::premises() const { return state_->premises(); }

Verdict MapProblem::check(std::span<const Premise> premises) {
  return guarded_z3([&] { return state_->check(premises); });
}

std::span<const Premise> MapProblem::core() const { return state_->core(); }

PartialMap MapProblem::map() const { return state_->map(); }

std::vector<Arrival> MapProblem::whole_map() const {
  std::vector<Arrival> result;
  for (const std::optional<Arrival>& arrival : map()) result.push_back(arrival.value());
  return result;
}

}  // namespace asterism
