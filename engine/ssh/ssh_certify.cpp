#include "engine/ssh/ssh_certify.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "axioms/axiom_solver.hpp"
#include "axioms/bench/lazy_grounding.hpp"
#include "axioms/bench/z3.hpp"
#include "core/error.hpp"
#include "engine/preference.hpp"
#include "engine/proof/certificate.hpp"
#include "engine/ssh/ssh_table.hpp"
#include "engine/ssh/ssh_tree.hpp"

namespace asterism {
namespace {

/// The search for a map preferred to the best known.
class PreferredMap {
 public:
  PreferredMap(const SshTable& table, const Theory& theory, std::vector<std::size_t> best,
               Deadline deadline)
      : table_(table),
        theory_(theory),
        best_(std::move(best)),
        deadline_(deadline),
        pair_solver_(theory.axioms, milliseconds_until(deadline)),
        solver_(simple_solver(context_)),
        grounding_(theory.axioms, context_, solver_) {
    // Cut short, it is never asked: exists() finds itself out of time as well.
    assert_choices();
    if (out_of_time()) return;
    solver_.add(is_preferred());
    grounding_.add(table_.general_facts(), context_.bool_val(true));
    for (std::size_t k = 0; k < table_.views() && !out_of_time(); ++k)
      for (const std::size_t j : choices_[k]) {
        const Fact sees = table_.sees(j, k);
        grounding_.add({&sees, 1}, at(k, j));
      }
  }

  /// inconsistent: there is none.
  Verdict exists() {
    return grounding_.solve(z3::expr_vector(context_), deadline_, [&] {
      const std::vector<std::size_t> firsts = solution();
      if (refute(firsts)) return true;
      const SshMap map = make_ssh_map(table_.experience(), dstates(firsts));
      if ((!theory_.planar || is_planar(map)) && extents_by_preference(map, theory_.axioms) < best_)
        return false;
      rule_out(firsts);
      return true;
    });
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

  bool joins(Extent extent, SshTable::ActionNumber action) const {
    return extent == Extent::place ? action != SshTable::travel
                                   : action == SshTable::travel || action == SshTable::turn_around;
  }

  /// "At most `bound` classes, if these actions join dstates to classes."
  z3::expr at_most(Extent extent, std::size_t bound) {
    if (extent == Extent::segment) return context_.bool_val(true);
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
      const Extent extent = theory_.axioms.preference()[i];
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

  /// Grounds the axioms on this map. Nothing new to say means that it satisfies them all.
  bool refute(std::span<const std::size_t> firsts) {
    std::vector<LazyGrounding::FoundFact> steps;
    for (std::size_t k = 1; k < firsts.size(); ++k)
      steps.push_back({table_.leads(firsts[k - 1], k - 1, firsts[k]), at(k - 1, firsts[k - 1]),
                       at(k, firsts[k])});
    return grounding_.refutes(steps, deadline_);
  }

  void rule_out(std::span<const std::size_t> firsts) {
    z3::expr_vector choices(context_);
    for (std::size_t k = 0; k < firsts.size(); ++k) choices.push_back(at(k, firsts[k]));
    solver_.add(!z3::mk_and(choices));
  }

  const SshTable& table_;
  const Theory& theory_;
  std::vector<std::size_t> best_;
  Deadline deadline_;

  AxiomSolver pair_solver_;  ///< of two views alone
  z3::context context_;
  z3::solver solver_;
  LazyGrounding grounding_;
  std::vector<std::vector<std::size_t>> choices_;  ///< for each view, first views of dstates
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> may_be_one_;  ///< by view
};

}  // namespace

Certificate certify(const Experience& experience, const Theory& theory,
                    std::span<const SshMap> models, const Stop& stop) {
  if (models.empty()) throw std::invalid_argument("no models to certify");
  const AxiomSet& axioms = theory.axioms;
  const SshTable table(experience);
  const auto best = extents_by_preference(models.front(), axioms);
  const auto is_model = [&](const SshMap& map) {
    if (extents_by_preference(map, axioms) != best || (theory.planar && !is_planar(map)))
      return Verdict::inconsistent;
    return check_model(
        axioms, table.general_facts(), map.dstates.size(), stop.deadline,
        [&](std::size_t k) { return table.step_facts(std::span(map.dstates).first(k + 1)); });
  };
  return certificate_of(models, is_model, [&] {
    return guarded_z3([&] { return PreferredMap(table, theory, best, stop.deadline).exists(); });
  });
}

}  // namespace asterism
