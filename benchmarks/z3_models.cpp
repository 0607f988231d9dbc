#include "benchmarks/z3_models.hpp"

#include <z3++.h>

#include <map>
#include <utility>
#include <vector>

#include "benchmarks/measure.hpp"
#include "engine/arm_table.hpp"

namespace asterism {
namespace {

using ArmPair = std::pair<ArmId, ArmId>;

/// The atoms at, joined and ahead of maps.lp; `joined` and `ahead` may also hold where nothing
/// forces them to, which only rules maps out, so each choice of `at` has a model iff its least one
/// is.
class Problem {
 public:
  explicit Problem(const Trace& trace) {
    for (const Visit& visit : trace.visits) table_.append(visit);
    choose_arrivals();
    join_gateways();
    order_places();
  }

  ModelCount count(double time_limit_s) {
    const Stopwatch stopwatch;
    ModelCount count;
    while (stopwatch.seconds() < time_limit_s) {
      z3::params parameters(context_);
      parameters.set("timeout",
                     static_cast<unsigned>((time_limit_s - stopwatch.seconds()) * 1000) + 1);
      solver_.set(parameters);
      const z3::check_result result = solver_.check();
      count.complete = result == z3::unsat;
      if (result != z3::sat) break;
      ++count.models;
      block(solver_.get_model());
    }
    return count;
  }

 private:
  z3::expr atom(const char* name, std::size_t i, std::size_t j) {
    return context_.bool_const((name + std::to_string(i) + "_" + std::to_string(j)).c_str());
  }
  z3::expr at(VisitId visit, ArmId arm) { return atom("at", visit.index(), arm.index()); }
  z3::expr is_new(VisitId visit) { return at(visit, table_.entered(visit)); }
  z3::expr ahead(ArmId arm, VisitId place) { return atom("ahead", arm.index(), place.index()); }

  IdRange<VisitId> visits_after_first() const { return {VisitId(1), VisitId(table_.visits())}; }

  // Where each visit arrived: at an arm of a place met before, or of a place of its own.
  void choose_arrivals() {
    const VisitId first(0);
    choices_.resize(table_.visits());
    solver_.add(is_new(first));
    choices_[first] = {table_.entered(first)};
    for (const VisitId k : visits_after_first()) {
      z3::expr_vector arrivals(context_);
      for (const ArmId arm : IdRange(ArmId(0), table_.first_arm(k)))
        if (table_.view(arm) == table_.seen(k)) choices_[k].push_back(arm);
      choices_[k].push_back(table_.entered(k));
      for (const ArmId arm : choices_[k]) {
        arrivals.push_back(at(k, arm));
        solver_.add(z3::implies(at(k, arm), is_new(table_.visit_of(arm))));
      }
      solver_.add(z3::mk_or(arrivals));
      solver_.add(z3::atmost(arrivals, 1));
    }
  }

  // A travel joins two gateways of different places (8), and no gateway to two.
  void join_gateways() {
    std::map<ArmId, z3::expr_vector> partners;
    for (const VisitId k : visits_after_first())
      for (const ArmId before : choices_[k.previous()])
        for (const ArmId to : choices_[k]) {
          const ArmId from = table_.left(k.previous(), before);
          const z3::expr travel = at(k.previous(), before) && at(k, to);
          if (table_.visit_of(from) == table_.visit_of(to)) {
            solver_.add(!travel);
            continue;
          }
          const ArmPair ends = std::minmax(from, to);
          const auto [joined, is_first] =
              joined_.try_emplace(ends, atom("joined", ends.first.index(), ends.second.index()));
          solver_.add(z3::implies(travel, joined->second));
          if (!is_first) continue;
          for (const ArmId end : {from, to})
            partners.try_emplace(end, context_).first->second.push_back(joined->second);
        }
    for (const auto& [gateway, joined] : partners) solver_.add(z3::atmost(joined, 1));
  }

  // What follows along a directed path (6), (10); no place follows itself (8).
  void order_places() {
    for (const auto& [ends, joined] : joined_)
      for (const auto& [from, to] : {ends, ArmPair(ends.second, ends.first)}) {
        solver_.add(z3::implies(joined, ahead(from, table_.visit_of(to))));
        for (const VisitId place : table_.all_visits())
          solver_.add(z3::implies(joined && ahead(table_.opposite(to), place), ahead(from, place)));
      }
    for (const ArmId arm : table_.all_arms()) solver_.add(!ahead(arm, table_.visit_of(arm)));
  }

  void block(const z3::model& model) {
    z3::expr_vector others(context_);
    for (const VisitId k : visits_after_first())
      for (const ArmId arm : choices_[k])
        if (model.eval(at(k, arm), true).is_true()) others.push_back(!at(k, arm));
    solver_.add(z3::mk_or(others));
  }

  ArmTable table_;
  z3::context context_;
  z3::solver solver_{context_, "QF_FD"};  // its SAT solver; the default one is far slower
  IdVector<VisitId, std::vector<ArmId>> choices_;
  std::map<ArmPair, z3::expr> joined_;
};

}  // namespace

ModelCount count_models_with_z3(const Trace& trace, double time_limit_s) {
  return Problem(trace).count(time_limit_s);
}

}  // namespace asterism
