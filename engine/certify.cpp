#include "engine/certify.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <stdexcept>

#include "axioms/axiom_solver.hpp"
#include "axioms/z3_vocabulary.hpp"
#include "core/error.hpp"
#include "engine/arm_table.hpp"
#include "engine/facts.hpp"
#include "planarity/euler.hpp"

namespace asterism {
namespace {

using Clock = std::chrono::steady_clock;

/// Sizes of the extents in order of preference.
std::vector<std::size_t> rank(const TopologicalMap& map, const AxiomSet& axioms) {
  std::vector<std::size_t> result;
  for (const std::string& extent : axioms.preference())
    result.push_back(extent == "path"    ? map.paths.size()
                     : extent == "place" ? map.places.size()
                                         : map.segments.size());
  return result;
}

unsigned milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
  return left.count() < 1 ? 1U : static_cast<unsigned>(left.count());
}

Verdict check_model(const ArmTable& table, const AxiomSet& axioms, std::span<const ArmIndex> named,
                    Clock::time_point deadline) {
  AxiomSolver solver(axioms, milliseconds_until(deadline));
  solver.add(general_facts());
  for (std::size_t k = 0; k < named.size(); ++k) {
    if (Clock::now() > deadline) return Verdict::undecided;
    solver.add(visit_facts(table, named.first(k + 1)));
  }
  return solver.check();
}

/// The search for a map preferred to the best known.
class PreferredMap {
 public:
  PreferredMap(const ArmTable& table, const AxiomSet& axioms, bool planar,
               std::span<const Assumption> assumptions, std::vector<std::size_t> best,
               Clock::time_point deadline)
      : table_(table),
        axioms_(axioms),
        planar_(planar),
        assumptions_(assumptions),
        best_(std::move(best)),
        deadline_(deadline),
        solver_(context_, z3::solver::simple()),
        grounder_(axioms),
        vocabulary_(context_, grounder_) {
    // Cut short, it is never asked: exists() finds itself out of time as well.
    assert_choices();
    if (out_of_time()) return;
    for (const Assumption& assumption : assumptions_) assume(assumption);
    solver_.add(is_preferred());
    ground(general_facts(), context_.bool_val(true));
    for (std::size_t k = 0; k < table_.visits() && !out_of_time(); ++k)
      ground(place_facts(table_, k), is_new(k));
  }

  /// inconsistent: there is none.
  Verdict exists() {
    while (!out_of_time()) {
      z3::params parameters(context_);
      parameters.set("timeout", milliseconds_until(deadline_));
      solver_.set(parameters);
      const z3::check_result result = solver_.check();
      if (result == z3::unsat) return Verdict::inconsistent;
      if (result == z3::unknown) return Verdict::undecided;
      const std::vector<ArmIndex> named = solution();
      if (refute(named)) continue;
      const TopologicalMap map = make_map(table_.trace(), table_.arrivals(named));
      if (planar_ && !is_planar(map)) {
        rule_out(shortest_prefix_not_planar(named));
        continue;
      }
      // The sums count a path that closes on itself as none, where axioms allow it.
      if (rank(map, axioms_) < best_) return Verdict::consistent;
      rule_out(named);
    }
    return Verdict::undecided;
  }

 private:
  bool out_of_time() const { return Clock::now() >= deadline_; }

  z3::expr at(std::size_t k, ArmIndex arm) {
    return context_.bool_const(("at_" + std::to_string(k) + "_" + std::to_string(arm)).c_str());
  }
  z3::expr is_new(std::size_t k) { return at(k, table_.entered(k)); }

  /// Whether the axioms let visit k be seen on coming in by this arm, all else apart.
  bool may_be_at(std::size_t k, ArmIndex arm) {
    const auto view = std::pair(table_.view(table_.opposite(arm)),
                                table_.view(table_.opposite(table_.entered(k))));
    const auto [entry, is_first] = may_show_.try_emplace(view, true);
    if (is_first) {
      AxiomSolver solver(axioms_, milliseconds_until(deadline_));
      solver.add(general_facts());
      solver.add(place_facts(table_, table_.visit_of(arm)));
      const auto facts = travel_facts(table_, k, arm, arm);
      solver.add(std::span(facts).first(1));  // what was seen, not the travel
      entry->second = solver.check() != Verdict::inconsistent;
    }
    return entry->second;
  }

  void assert_choices() {
    const std::size_t visits = table_.visits();
    choices_.resize(visits);
    std::map<ArmIndex, z3::expr_vector> used;  // by what a gateway gets a segment
    const auto use = [&](ArmIndex arm, const z3::expr& by) {
      used.try_emplace(arm, context_).first->second.push_back(by);
    };
    for (std::size_t k = 0; k < visits && !out_of_time(); ++k) {
      for (ArmIndex arm = 0; k > 0 && arm < table_.first_arm(k); ++arm)
        if (may_be_at(k, arm)) choices_[k].push_back(arm);
      choices_[k].push_back(table_.entered(k));
      z3::expr_vector one(context_);
      for (const ArmIndex arm : choices_[k]) {
        one.push_back(at(k, arm));
        if (table_.visit_of(arm) != k)
          solver_.add(z3::implies(at(k, arm), is_new(table_.visit_of(arm))));
        if (k > 0) use(arm, at(k, arm));
        if (k + 1 < visits) use(table_.left(k, arm), at(k, arm));
      }
      solver_.add(z3::mk_or(one));
      solver_.add(z3::atmost(one, 1));
    }
    for (const auto& [arm, by] : used) {
      const z3::expr linked = context_.bool_const(("linked_" + std::to_string(arm)).c_str());
      solver_.add(linked == z3::mk_or(by));
      linked_.push_back(linked);
    }
  }

  /// "Visit k was at the place first seen at visit j", in any way in.
  z3::expr is_at_place(std::size_t k, std::size_t j) {
    z3::expr_vector ways(context_);
    for (const ArmIndex arm : choices_[k])
      if (table_.visit_of(arm) == j) ways.push_back(at(k, arm));
    return z3::mk_or(ways);
  }

  void assume(const Assumption& assumption) {
    const auto [one, other] = std::minmax({assumption.one.index(), assumption.other.index()});
    for (std::size_t j = 0; j <= other; ++j) {
      const z3::expr first = is_at_place(one, j);
      const z3::expr second = is_at_place(other, j);
      solver_.add(assumption.kind == Assumption::Kind::same ? first == second : !(first && second));
    }
  }

  /// "The extent is at most `bound`": each a sum of the choices.             [DESIGN §6]
  z3::expr at_most(const std::string& extent, int bound) {
    z3::expr_vector terms(context_);
    std::vector<int> weights;
    const auto add = [&](const z3::expr& term, std::size_t weight) {
      terms.push_back(term);
      weights.push_back(static_cast<int>(weight));
    };
    if (extent == "place" || extent == "path")
      for (std::size_t k = 0; k < table_.visits(); ++k)
        add(is_new(k), extent == "place" ? 1 : table_.star_size(k));
    if (extent == "path") {
      // 2 |paths| = Σ new(k) arms(k) − Σ linked, and −linked = ¬linked − 1.
      bound = 2 * bound + static_cast<int>(linked_.size());
      for (const z3::expr& linked : linked_) add(!linked, 1);
    }
    if (extent == "segment") {
      bound *= 2;
      for (const z3::expr& linked : linked_) add(linked, 1);
    }
    if (bound < 0) return context_.bool_val(false);
    return z3::pble(terms, weights.data(), bound);
  }

  z3::expr is_preferred() {
    z3::expr_vector ways(context_);
    z3::expr_vector equal_so_far(context_);
    for (std::size_t i = 0; i < best_.size(); ++i) {
      const std::string& extent = axioms_.preference()[i];
      const int best = static_cast<int>(best_[i]);
      z3::expr_vector way(context_);
      for (const z3::expr& equal : equal_so_far) way.push_back(equal);
      way.push_back(at_most(extent, best - 1));
      ways.push_back(z3::mk_and(way));
      equal_so_far.push_back(at_most(extent, best));
    }
    return z3::mk_or(ways);
  }

  std::vector<ArmIndex> solution() {
    const z3::model model = solver_.get_model();
    std::vector<ArmIndex> named;
    for (std::size_t k = 0; k < choices_.size(); ++k)
      for (const ArmIndex arm : choices_[k])
        if (model.eval(at(k, arm), true).is_true()) named.push_back(arm);
    if (named.size() != choices_.size()) throw SolverError("z3: not one arm a visit in a solution");
    return named;
  }

  /// Facts that hold where a choice does, and the instances they lead to.
  void ground(std::span<const Fact> facts, const z3::expr& choice) {
    for (const Fact& fact : facts) {
      solver_.add(z3::implies(choice, vocabulary_.atom(grounder_.atom(fact))));
      grounder_.add(fact, [&](const Grounder::Instance& instance) { assert_new(instance); });
    }
  }

  bool assert_new(const Grounder::Instance& instance) {
    return assert_new(vocabulary_.instance(instance));
  }
  bool assert_new(const z3::expr& formula) {
    if (!asserted_.insert(formula.id()).second) return false;
    kept_.push_back(formula);
    solver_.add(formula);
    return true;
  }

  /// Grounds the axioms on this map. Nothing new to say means that it satisfies them all. Stops
  /// when out of time, as if there were more to say.
  bool refute(std::span<const ArmIndex> named) {
    bool any = false;
    grounder_.push();
    for (std::size_t k = 1; k < named.size(); ++k) {
      if (out_of_time()) {
        any = true;
        break;
      }
      const auto facts = travel_facts(table_, k, table_.left(k - 1, named[k - 1]), named[k]);
      for (const Fact& fact : facts) {
        any |= assert_new(z3::implies(at(k - 1, named[k - 1]) && at(k, named[k]),
                                      vocabulary_.atom(grounder_.atom(fact))));
        grounder_.add(fact,
                      [&](const Grounder::Instance& instance) { any |= assert_new(instance); });
      }
    }
    grounder_.pop();
    return any;
  }

  std::span<const ArmIndex> shortest_prefix_not_planar(std::span<const ArmIndex> named) const {
    std::size_t k = 1;
    while (is_planar(make_map(table_.trace(), table_.arrivals(named.first(k))))) ++k;
    return named.first(k);
  }

  void rule_out(std::span<const ArmIndex> named) {
    z3::expr_vector choices(context_);
    for (std::size_t k = 1; k < named.size(); ++k) choices.push_back(at(k, named[k]));
    solver_.add(!z3::mk_and(choices));
  }

  const ArmTable& table_;
  const AxiomSet& axioms_;
  bool planar_;
  std::span<const Assumption> assumptions_;
  std::vector<std::size_t> best_;
  Clock::time_point deadline_;

  z3::context context_;
  z3::solver solver_;
  Grounder grounder_;
  Z3Vocabulary vocabulary_;
  std::vector<std::vector<ArmIndex>> choices_;  ///< of each visit
  std::vector<z3::expr> linked_;                ///< one a gateway that may get a segment
  std::map<std::pair<ArmIndex, ArmIndex>, bool> may_show_;
  std::set<unsigned> asserted_;  ///< ids of formulas, valid while ...
  std::vector<z3::expr> kept_;   ///< ... they are kept
};

}  // namespace

Certificate certify(const Trace& trace, const AxiomSet& axioms, bool planar,
                    std::span<const std::vector<Arrival>> models, double seconds,
                    std::span<const Assumption> assumptions) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(std::min(seconds, 1e6)));
  ArmTable table;
  for (const Visit& visit : trace.visits) table.append(visit);

  std::optional<std::vector<std::size_t>> best;
  for (const auto& model : models) {
    const TopologicalMap map = make_map(trace, model);
    if (!best) best = rank(map, axioms);
    const bool is_as_assumed = std::ranges::all_of(assumptions, [&](const Assumption& assumption) {
      return agrees(assumption, map.visits.at(assumption.one.index()),
                    map.visits.at(assumption.other.index()));
    });
    if (rank(map, axioms) != *best || (planar && !is_planar(map)) || !is_as_assumed)
      return Certificate::refuted;
    switch (check_model(table, axioms, table.named(model), deadline)) {
      case Verdict::inconsistent:
        return Certificate::refuted;
      case Verdict::undecided:
        return Certificate::not_shown;
      case Verdict::consistent:
        break;
    }
  }
  if (!best) throw std::invalid_argument("no models to certify");
  const Verdict preferred = guarded_z3(
      [&] { return PreferredMap(table, axioms, planar, assumptions, *best, deadline).exists(); });
  switch (preferred) {
    case Verdict::inconsistent:
      return Certificate::shown;
    case Verdict::consistent:
      return Certificate::refuted;
    case Verdict::undecided:
      break;
  }
  return Certificate::not_shown;
}

}  // namespace asterism
