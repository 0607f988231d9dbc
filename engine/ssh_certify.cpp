#include "engine/ssh_certify.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "axioms/axiom_solver.hpp"
#include "axioms/z3_vocabulary.hpp"
#include "core/deadline.hpp"
#include "core/error.hpp"
#include "engine/ssh_table.hpp"
#include "engine/ssh_tree.hpp"

namespace asterism {
namespace {

using DState = SshTable::DState;

std::vector<DState> numbers(std::span<const DStateId> dstates) {
  std::vector<DState> result;
  for (const DStateId dstate : dstates) result.push_back(static_cast<DState>(dstate.index()));
  return result;
}

Verdict check_model(const SshTable& table, const AxiomSet& axioms, std::span<const DState> dstates,
                    Deadline deadline) {
  AxiomSolver solver(axioms, milliseconds_until(deadline));
  solver.add(table.general_facts());
  for (std::size_t k = 0; k < dstates.size(); ++k) {
    if (is_over(deadline)) return Verdict::undecided;
    solver.add(table.step_facts(dstates.first(k + 1)));
  }
  return solver.check();
}

/// The search for a map preferred to the best known.
class PreferredMap {
 public:
  PreferredMap(const SshTable& table, const AxiomSet& axioms, bool planar,
               std::vector<std::size_t> best, Deadline deadline)
      : table_(table),
        axioms_(axioms),
        planar_(planar),
        best_(std::move(best)),
        deadline_(deadline),
        pair_solver_(axioms, milliseconds_until(deadline)),
        solver_(simple_solver(context_)),
        grounder_(axioms),
        vocabulary_(context_, grounder_) {
    // Cut short, it is never asked: exists() finds itself out of time as well.
    assert_choices();
    if (out_of_time()) return;
    solver_.add(is_preferred());
    for (const Fact& fact : table_.general_facts()) ground(fact, context_.bool_val(true));
    for (std::size_t k = 0; k < table_.views() && !out_of_time(); ++k)
      for (const std::size_t j : choices_[k]) ground(table_.sees(j, k), at(k, j));
  }

  /// inconsistent: there is none.
  Verdict exists() {
    while (!out_of_time()) {
      set_timeout(solver_, milliseconds_until(deadline_));
      const z3::check_result result = solver_.check();
      if (result == z3::unsat) return Verdict::inconsistent;
      if (result == z3::unknown) return Verdict::undecided;
      const std::vector<std::size_t> firsts = solution();
      if (refute(firsts)) continue;
      const SshMap map = make_ssh_map(table_.experience(), dstates(firsts));
      if ((!planar_ || is_planar(map)) && extents_of(map, axioms_.preference()) < best_)
        return Verdict::consistent;
      rule_out(firsts);
    }
    return Verdict::undecided;
  }

 private:
  bool out_of_time() const { return is_over(deadline_); }

  z3::expr at(std::size_t k, std::size_t j) {
    return context_.bool_const(("at_" + std::to_string(k) + "_" + std::to_string(j)).c_str());
  }

  /// Whether the axioms let views k and j be seen at one dstate, all else apart.
  bool may_be_one(std::size_t k, std::size_t j) {
    const auto views = std::pair(table_.view(j), table_.view(k));
    const auto [entry, is_first] = may_be_one_.try_emplace(views, true);
    if (is_first) {
      pair_solver_.push();
      pair_solver_.add(std::vector{table_.sees(j, j), table_.sees(j, k)});
      entry->second = pair_solver_.check() != Verdict::inconsistent;
      pair_solver_.pop();
    }
    return entry->second;
  }

  void assert_choices() {
    choices_.resize(table_.views());
    for (std::size_t k = 0; k < table_.views() && !out_of_time(); ++k) {
      z3::expr_vector one(context_);
      for (std::size_t j = 0; j <= k; ++j) {
        if (!may_be_one(k, j)) continue;
        choices_[k].push_back(j);
        one.push_back(at(k, j));
        solver_.add(z3::implies(at(k, j), at(j, j)));
      }
      solver_.add(z3::mk_or(one));
      solver_.add(z3::atmost(one, 1));
    }
  }

  bool joins(const std::string& extent, SshTable::ActionNumber action) const {
    return extent == "place" ? action != SshTable::travel
                             : action == SshTable::travel || action == SshTable::turn_around;
  }

  /// "At most `bound` classes, if these actions join dstates to classes."
  z3::expr at_most(const std::string& extent, std::size_t bound) {
    if (extent == "segment") return context_.bool_val(true);
    const std::size_t views = table_.views();
    z3::expr_vector terms(context_);
    for (std::size_t k = 0; k < views; ++k) terms.push_back(at(k, k));
    // joined[i][j]: in one class, as far as the steps looked at tell.
    const z3::expr no = context_.bool_val(false);
    std::vector<std::vector<z3::expr>> joined(views, std::vector<z3::expr>(views, no));
    for (std::size_t i = 0; i < views; ++i) joined[i][i] = context_.bool_val(true);
    for (std::size_t k = 1; k < views && !out_of_time(); ++k) {
      if (!joins(extent, table_.action(k - 1))) continue;
      const Members before = members(joined, k - 1, k);
      const Members after = members(joined, k, k);
      z3::expr_vector known(context_);  // in one class already
      for (const auto& [i, is_with_after] : after)
        if (std::ranges::binary_search(choices_[k - 1], i))
          known.push_back(at(k - 1, i) && is_with_after);
      for (const auto& [i, is_with_before] : before)
        for (const auto& [j, is_with_after] : after)
          if (i != j)
            joined[i][j] = joined[j][i] =
                (joined[i][j] || (is_with_before && is_with_after)).simplify();
      // Classes = dstates − steps that join two, and −join = ¬join − 1.
      terms.push_back(z3::mk_or(known));
      ++bound;
    }
    const std::vector<int> weights(terms.size(), 1);
    return z3::pble(terms, weights.data(), static_cast<int>(bound));
  }

  /// Dstates first experienced at these views, each with what says that it is in a class.
  using Members = std::vector<std::pair<std::size_t, z3::expr>>;

  /// Those up to `last` that may be in one class with the dstate of view k.
  Members members(const std::vector<std::vector<z3::expr>>& joined, std::size_t k,
                  std::size_t last) {
    Members result;
    for (std::size_t i = 0; i <= last; ++i) {
      z3::expr_vector ways(context_);
      for (const std::size_t j : choices_[k])
        if (!joined[i][j].is_false()) ways.push_back(at(k, j) && joined[i][j]);
      if (!ways.empty()) result.emplace_back(i, z3::mk_or(ways).simplify());
    }
    return result;
  }

  z3::expr is_preferred() {
    z3::expr_vector ways(context_);
    z3::expr_vector equal_so_far(context_);
    for (std::size_t i = 0; i < best_.size(); ++i) {
      const std::string& extent = axioms_.preference()[i];
      z3::expr_vector way(context_);
      for (const z3::expr& equal : equal_so_far) way.push_back(equal);
      way.push_back(best_[i] == 0 ? context_.bool_val(false) : at_most(extent, best_[i] - 1));
      ways.push_back(z3::mk_and(way));
      equal_so_far.push_back(at_most(extent, best_[i]));
    }
    return z3::mk_or(ways);
  }

  /// The view at which the dstate of each view was first experienced.
  std::vector<std::size_t> solution() {
    const z3::model model = solver_.get_model();
    std::vector<std::size_t> firsts;
    for (std::size_t k = 0; k < table_.views(); ++k)
      for (const std::size_t j : choices_[k])
        if (model.eval(at(k, j), true).is_true()) firsts.push_back(j);
    if (firsts.size() != table_.views())
      throw SolverError("z3: not one dstate a view in a solution");
    return firsts;
  }

  static std::vector<DStateId> dstates(std::span<const std::size_t> firsts) {
    std::vector<DStateId> result;
    std::size_t next = 0;
    for (std::size_t k = 0; k < firsts.size(); ++k)
      result.push_back(firsts[k] == k ? DStateId(next++) : result[firsts[k]]);
    return result;
  }

  /// A fact that holds where a choice does, and the instances it leads to.
  /// @return whether anything was new
  bool ground(const Fact& fact, const z3::expr& choice) {
    bool any = assert_new(z3::implies(choice, vocabulary_.atom(grounder_.atom(fact))));
    grounder_.add(fact, [&](const Grounder::Instance& instance) {
      any |= assert_new(vocabulary_.instance(instance));
    });
    return any;
  }

  bool assert_new(const z3::expr& formula) {
    if (!asserted_.insert(formula.id()).second) return false;
    kept_.push_back(formula);
    solver_.add(formula);
    return true;
  }

  /// Grounds the axioms on this map. Nothing new to say means that it satisfies them all. Stops
  /// when out of time, as if there were more to say.
  bool refute(std::span<const std::size_t> firsts) {
    bool any = false;
    grounder_.push();
    for (std::size_t k = 1; k < firsts.size(); ++k) {
      if (out_of_time()) {
        any = true;
        break;
      }
      any |= ground(table_.leads(firsts[k - 1], k - 1, firsts[k]),
                    at(k - 1, firsts[k - 1]) && at(k, firsts[k]));
    }
    grounder_.pop();
    return any;
  }

  void rule_out(std::span<const std::size_t> firsts) {
    z3::expr_vector choices(context_);
    for (std::size_t k = 0; k < firsts.size(); ++k) choices.push_back(at(k, firsts[k]));
    solver_.add(!z3::mk_and(choices));
  }

  const SshTable& table_;
  const AxiomSet& axioms_;
  bool planar_;
  std::vector<std::size_t> best_;
  Deadline deadline_;

  AxiomSolver pair_solver_;  ///< of two views alone
  z3::context context_;
  z3::solver solver_;
  Grounder grounder_;
  Z3Vocabulary vocabulary_;
  std::vector<std::vector<std::size_t>> choices_;  ///< for each view, first views of dstates
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> may_be_one_;  ///< by view
  std::set<unsigned> asserted_;  ///< ids of formulas, valid while ...
  std::vector<z3::expr> kept_;   ///< ... they are kept
};

}  // namespace

Certificate certify(const Experience& experience, const AxiomSet& axioms, bool planar,
                    std::span<const SshMap> models, double seconds) {
  const Deadline deadline = deadline_in(seconds);
  if (models.empty()) throw std::invalid_argument("no models to certify");
  const SshTable table(experience);
  const std::vector<std::size_t> best = extents_of(models.front(), axioms.preference());
  for (const SshMap& map : models) {
    if (extents_of(map, axioms.preference()) != best || (planar && !is_planar(map)))
      return Certificate::refuted;
    switch (check_model(table, axioms, numbers(map.dstates), deadline)) {
      case Verdict::inconsistent:
        return Certificate::refuted;
      case Verdict::undecided:
        return Certificate::not_shown;
      case Verdict::consistent:
        break;
    }
  }
  const Verdict preferred =
      guarded_z3([&] { return PreferredMap(table, axioms, planar, best, deadline).exists(); });
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
