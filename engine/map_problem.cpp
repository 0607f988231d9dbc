#include "engine/map_problem.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "axioms/z3_vocabulary.hpp"
#include "core/deadline.hpp"
#include "engine/claim_circuit.hpp"
#include "engine/facts.hpp"
#include "engine/free_association.hpp"
#include "engine/query_map.hpp"
#include "planarity/euler.hpp"

namespace asterism {
namespace {

/// Whether a map without some visits says the same of it: what it says of which visits were to one
/// place stays, and so does what it says of visits that are left out, since that is free.
bool is_about_places(const Claim& claim) {
  if (const auto* all = std::get_if<Claim::All>(&claim.is))
    return std::ranges::all_of(all->parts, is_about_places);
  if (const auto* any = std::get_if<Claim::Any>(&claim.is))
    return std::ranges::all_of(any->parts, is_about_places);
  if (const auto* negation = std::get_if<Claim::Not>(&claim.is))
    return is_about_places(negation->part.front());
  return std::holds_alternative<Claim::Same>(claim.is);
}

void collect_visits(const Claim& claim, std::set<std::size_t>& visits) {
  if (const auto* all = std::get_if<Claim::All>(&claim.is))
    for (const Claim& part : all->parts) collect_visits(part, visits);
  if (const auto* any = std::get_if<Claim::Any>(&claim.is))
    for (const Claim& part : any->parts) collect_visits(part, visits);
  if (const auto* negation = std::get_if<Claim::Not>(&claim.is))
    collect_visits(negation->part.front(), visits);
  if (const auto* same = std::get_if<Claim::Same>(&claim.is))
    visits.insert({same->one.index(), same->other.index()});
}

}  // namespace

class MapProblem::State {
 public:
  State(const Trace& trace, const AxiomSet& axioms, Deadline deadline)
      : deadline_(deadline),
        table_(trace),
        solver_(simple_solver(context_)),
        grounder_(axioms),
        vocabulary_(context_, grounder_),
        association_(context_, solver_, table_),
        circuit_(association_, solver_),
        planarity_(context_.bool_const("planarity")),
        is_shipped_(axioms.is_shipped()) {
    for (const Axiom& axiom : grounder_.axioms().axioms())
      axioms_.push_back(context_.bool_const(("axiom_" + axiom.name).c_str()));
    z3::params parameters(context_);
    parameters.set("relevancy", 0U);  // what is told says what is relevant: half the time
    solver_.set(parameters);
    ground(general_facts(), context_.bool_val(true));
  }

  Premise add(const Claim& claim) {
    const std::string name = "claim_" + std::to_string(claims_.size());
    claims_.push_back({claim, context_.bool_const(name.c_str())});
    solver_.add(z3::implies(claims_.back().literal, circuit_.formula(claim)));
    return {Premise::Kind::claim, claims_.size() - 1};
  }

  std::vector<Premise> premises(bool planar) const {
    std::vector<Premise> result;
    for (std::size_t k = 0; k < table_.visits(); ++k) result.push_back({Premise::Kind::visit, k});
    const std::vector<Axiom>& axioms = grounder_.axioms().axioms();
    for (std::size_t i = 0; i < axioms.size(); ++i)
      if (!axioms[i].by_signature) result.push_back({Premise::Kind::axiom, i});
    if (planar) result.push_back({Premise::Kind::planarity});
    return result;
  }

  Verdict check(std::span<const Premise> premises) {
    const std::set<Premise> in_force(premises.begin(), premises.end());
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
    std::map<std::size_t, PlaceId> places;  // by first visit
    for (std::size_t k = 0; k < named_.size(); ++k) {
      if (named_[k] == FreeAssociation::untold) continue;
      const std::size_t first = table_.visit_of(named_[k]);
      const PlaceId place = places.try_emplace(first, places.size()).first->second;
      result[k] = Arrival{place, named_[k] - table_.first_arm(first)};
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

  bool leaves_visits_open(const std::set<Premise>& in_force) const {
    for (std::size_t k = 0; k < table_.visits(); ++k)
      if (!in_force.contains({Premise::Kind::visit, k})) return true;
    return false;
  }

  bool has_all_axioms(const std::set<Premise>& in_force) const {
    const std::vector<Axiom>& axioms = grounder_.axioms().axioms();
    for (std::size_t i = 0; i < axioms.size(); ++i)
      if (!axioms[i].by_signature && !in_force.contains({Premise::Kind::axiom, i})) return false;
    return true;
  }

  /// The same of fewer visits, round those that claims are about. The visits of a map that are left
  /// make a map, since all that were to one place saw one star: so if these cannot be, nor can all,
  /// and they are sooner decided.
  std::vector<std::set<Premise>> parts_of(const std::set<Premise>& in_force) const {
    std::set<std::size_t> named;
    for (const Premise& premise : in_force)
      if (premise.kind == Premise::Kind::claim)
        collect_visits(claims_[premise.number].claim, named);
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
    for (std::size_t k = 0; k < table_.visits(); ++k)
      if (nothing_else_told && !in_force.contains({Premise::Kind::visit, k}))
        assumptions.push_back(!association_.told(k));
      else
        prepare(k);
    while (!out_of_time()) {
      set_timeout(solver_, milliseconds_until(deadline_));
      const z3::check_result result = solver_.check(assumptions);
      if (result == z3::unknown) return Verdict::undecided;
      if (result == z3::unsat) {
        core_.clear();
        const z3::expr_vector core = solver_.unsat_core();
        for (unsigned i = 0; i < core.size(); ++i)
          if (const auto of = premise_of.find(core[static_cast<int>(i)].id());
              of != premise_of.end())
            core_.push_back(of->second);
        std::ranges::sort(core_);
        return Verdict::inconsistent;
      }
      named_ = association_.named(solver_.get_model());
      if (refute(in_force) || rule_out_crossing(in_force) || rule_out_miscounted(in_force))
        continue;
      return Verdict::consistent;
    }
    return Verdict::undecided;
  }

  bool out_of_time() const { return is_over(deadline_); }

  /// What holds wherever a visit that is told of was. Cut short, it is not asked: check() finds
  /// itself out of time as well.
  void prepare(std::size_t k) {
    if (!prepared_.insert(k).second) return;
    association_.choose(k);
    ground(place_facts(table_, k), association_.is_new(k));
    for (const std::size_t j : prepared_) {
      if (out_of_time()) return;
      const auto [place, visit] = std::minmax(j, k);
      const ArmIndex first = table_.first_arm(place);
      for (ArmIndex arm = first; arm < first + table_.star_size(place); ++arm)
        if (place != visit || arm == table_.entered(visit)) {
          const auto facts = travel_facts(table_, visit, arm, arm);
          ground(std::span(facts).first(1), association_.at(visit, arm));  // what was seen there
        }
    }
  }

  z3::expr literal(const Premise& premise) const {
    switch (premise.kind) {
      case Premise::Kind::visit:
        return association_.told(premise.number);
      case Premise::Kind::axiom:
        return axioms_.at(premise.number);
      case Premise::Kind::claim:
        return claims_.at(premise.number).literal;
      case Premise::Kind::planarity:
        break;
    }
    return planarity_;
  }

  bool is_told(std::size_t k) const { return named_[k] != FreeAssociation::untold; }

  /// Facts that hold where a choice does, and the instances they lead to.
  void ground(std::span<const Fact> facts, const z3::expr& choice) {
    for (const Fact& fact : facts) {
      solver_.add(z3::implies(choice, vocabulary_.atom(grounder_.atom(fact))));
      grounder_.add(fact, [&](const Grounder::Instance& instance) { assert_new(instance); });
    }
  }

  /// @return  whether it was not yet asserted
  bool assert_new(const Grounder::Instance& instance) {
    return assert_new(z3::implies(axioms_[number_of(instance)], vocabulary_.instance(instance)));
  }
  bool assert_new(const z3::expr& formula) {
    if (!asserted_.insert(formula.id()).second) return false;
    kept_.push_back(formula);
    solver_.add(formula);
    return true;
  }
  std::size_t number_of(const Grounder::Instance& instance) const {
    return static_cast<std::size_t>(instance.axiom - grounder_.axioms().axioms().data());
  }

  /// Grounds the axioms on this map. Nothing new to say means that it satisfies those in force.
  /// Stops when out of time, as if there were more to say.
  bool refute(const std::set<Premise>& in_force) {
    bool any = false;
    grounder_.push();
    for (std::size_t k = 1; k < named_.size() && !out_of_time(); ++k) {
      if (!is_told(k - 1) || !is_told(k)) continue;
      const auto facts = travel_facts(table_, k, table_.left(k - 1, named_[k - 1]), named_[k]);
      for (const Fact& fact : std::span(facts).subspan(1)) {
        any |= assert_new(
            z3::implies(association_.at(k - 1, named_[k - 1]) && association_.at(k, named_[k]),
                        vocabulary_.atom(grounder_.atom(fact))));
        grounder_.add(fact, [&](const Grounder::Instance& instance) {
          const bool is_new = assert_new(instance);
          any |= is_new && in_force.contains({Premise::Kind::axiom, number_of(instance)});
        });
      }
    }
    grounder_.pop();
    return any || out_of_time();
  }

  bool rule_out_crossing(const std::set<Premise>& in_force) {
    if (!in_force.contains({Premise::Kind::planarity})) return false;
    auto part = part_not_planar(sketch_of(table_.trace(), map()).map);
    if (!part) return false;
    TopologicalMap sketch = *std::move(part);
    // The fewest segments: what is left is not planar, and is without any one of them.
    for (std::size_t i = 0; i < sketch.segments.size();) {
      TopologicalMap without = sketch;
      without.segments.erase(without.segments.begin() + static_cast<std::ptrdiff_t>(i));
      if (is_planar(without))
        ++i;
      else
        sketch = std::move(without);
    }
    z3::expr_vector segments(context_);
    for (const auto& [one, other] : sketch.segments) {
      const auto arm = [&](const PlaceArm& gateway) {
        const VisitId first = sketch.places[gateway.place.index()].first_visit;
        return static_cast<ArmIndex>(table_.first_arm(first.index()) + gateway.arm);
      };
      segments.push_back(association_.linked(arm(one), arm(other)));
    }
    solver_.add(z3::implies(planarity_, !z3::mk_and(segments)));
    return true;
  }

  /// The closed form counts a path that closes on itself as none, where axioms allow it.
  bool rule_out_miscounted(const std::set<Premise>& in_force) {
    for (std::size_t k = 0; k < named_.size(); ++k)
      if (!is_told(k)) return false;
    const std::vector<Arrival> arrivals = table_.arrivals(named_);
    QueryMap map(table_.trace());
    map.set(arrivals);
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      if (!in_force.contains({Premise::Kind::claim, i}) || holds(claims_[i].claim, map)) continue;
      z3::expr_vector choices(context_);
      for (std::size_t k = 0; k < named_.size(); ++k)
        choices.push_back(association_.at(k, named_[k]));
      solver_.add(!z3::mk_and(choices) || !claims_[i].literal);
      return true;
    }
    return false;
  }

  Deadline deadline_;
  ArmTable table_;
  z3::context context_;
  z3::solver solver_;
  Grounder grounder_;
  Z3Vocabulary vocabulary_;
  FreeAssociation association_;
  ClaimCircuit circuit_;
  std::vector<z3::expr> axioms_;  ///< one literal each
  z3::expr planarity_;
  bool is_shipped_;
  std::vector<AddedClaim> claims_;

  std::set<std::size_t> prepared_;  ///< visits

  std::vector<Premise> core_;
  std::vector<ArmIndex> named_;
  std::set<unsigned> asserted_;  ///< ids of formulas, valid while ...
  std::vector<z3::expr> kept_;   ///< ... they are kept
};

MapProblem::MapProblem(const Trace& trace, const AxiomSet& axioms, double seconds) {
  state_ = guarded_z3([&] { return std::make_unique<State>(trace, axioms, deadline_in(seconds)); });
}
MapProblem::~MapProblem() = default;
MapProblem::MapProblem(MapProblem&&) noexcept = default;
MapProblem& MapProblem::operator=(MapProblem&&) noexcept = default;

Premise MapProblem::add(const Claim& claim) {
  return guarded_z3([&] { return state_->add(claim); });
}

std::vector<Premise> MapProblem::premises(bool planar) const { return state_->premises(planar); }

Verdict MapProblem::check(std::span<const Premise> premises) {
  return guarded_z3([&] { return state_->check(premises); });
}

std::span<const Premise> MapProblem::core() const { return state_->core(); }

PartialMap MapProblem::map() const { return state_->map(); }

}  // namespace asterism
