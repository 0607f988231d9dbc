#include "engine/proof/free_association.hpp"

#include <algorithm>

namespace asterism {
namespace {

template <class One, class Other>
std::string name(const char* what, One one, Other other) {
  return what + ("_" + std::to_string(one.index())) + "_" + std::to_string(other.index());
}

}  // namespace

FreeAssociation::FreeAssociation(z3::context& context, z3::solver& solver, const ArmTable& table)
    : context_(context), solver_(solver), table_(table), at_(table.visits()) {
  for (const VisitId k : table.all_visits()) {
    told_.push_back(context.bool_const(("told_" + std::to_string(k.index())).c_str()));
    for (const ArmId arm : choices(k)) {
      at_[k].push_back(context.bool_const(name("at", k, arm).c_str()));
      const VisitId place = table.visit_of(arm);
      if (place != k) solver.add(z3::implies(at_[k].back(), is_new(place)));
      solver.add(z3::implies(at_[k].back(), told_[k]));
    }
  }
}

void FreeAssociation::choose(VisitId k) {
  z3::expr_vector one(context_);
  for (const z3::expr& choice : at_[k]) one.push_back(choice);
  solver_.add(z3::implies(told_[k], z3::mk_or(one)));
  solver_.add(z3::atmost(one, 1));
}

z3::expr FreeAssociation::at(VisitId k, ArmId arm) const {
  return table_.visit_of(arm) == k ? is_new(k) : at_[k][arm.index()];
}

std::vector<ArmId> FreeAssociation::choices(VisitId k) const {
  std::vector<ArmId> arms;
  for (const ArmId arm : IdRange(ArmId(0), table_.first_arm(k))) arms.push_back(arm);
  arms.push_back(table_.entered(k));
  return arms;
}

z3::expr FreeAssociation::here(VisitId k, VisitId first_visit) const {
  if (k == first_visit) return is_new(k);
  z3::expr_vector arms(context_);
  for (const ArmId arm : table_.arms(first_visit)) arms.push_back(at_[k][arm.index()]);
  return z3::mk_or(arms);
}

z3::expr FreeAssociation::same(VisitId i, VisitId j) {
  if (i == j) return told(i);
  const auto [earlier, later] = std::minmax(i, j);
  const auto known = same_.find({earlier, later});
  if (known != same_.end()) return known->second;
  z3::expr_vector places(context_);
  for (const VisitId first : IdRange(VisitId(0), earlier.next()))
    places.push_back(here(earlier, first) && here(later, first));
  const z3::expr same = context_.bool_const(name("same", earlier, later).c_str());
  solver_.add(same == z3::mk_or(places));
  return same_.emplace(std::pair(earlier, later), same).first->second;
}

z3::expr FreeAssociation::coincide(OwnArm one, OwnArm other) {
  if (one.visit == other.visit)
    return one.arm == other.arm ? told(one.visit) : context_.bool_val(false);
  if (one.visit > other.visit) std::swap(one, other);
  const auto steps = [&](const OwnArm& own) {
    const std::size_t size = table_.star_size(own.visit);
    return (own.arm + size - table_.position(table_.entered(own.visit))) % size;
  };
  z3::expr_vector ways(context_);
  for (const ArmId arm : choices(one.visit)) {
    const VisitId place = table_.visit_of(arm);
    const ArmId meant = table_.clockwise(arm, steps(one) % table_.star_size(place));
    for (const ArmId entered : table_.arms(place))
      if (table_.clockwise(entered, steps(other) % table_.star_size(place)) == meant)
        ways.push_back(at(one.visit, arm) && at(other.visit, entered));
  }
  return z3::mk_or(ways);
}

z3::expr FreeAssociation::linked(ArmId one, ArmId other) {
  if (one > other) std::swap(one, other);
  const auto known = linked_.find({one, other});
  if (known != linked_.end()) return known->second;
  const z3::expr linked = context_.bool_const(name("linked", one, other).c_str());
  for (const VisitId k : IdRange(VisitId(1), VisitId(table_.visits()))) {
    const VisitId k_before = k.previous();
    for (const ArmId entered : {one, other}) {
      const ArmId left = entered == one ? other : one;
      if (table_.visit_of(entered) > k || table_.visit_of(left) > k_before) continue;
      if (table_.visit_of(entered) == k && entered != table_.entered(k)) continue;
      for (const ArmId before : choices(k_before))
        if (table_.left(k_before, before) == left)
          solver_.add(z3::implies(at(k_before, before) && at(k, entered), linked));
    }
  }
  return linked_.emplace(std::pair(one, other), linked).first->second;
}

const std::vector<z3::expr>& FreeAssociation::has_segment() {
  if (!has_segment_.empty()) return has_segment_;
  std::map<ArmId, z3::expr_vector> used;  // by what a gateway gets a segment
  const VisitId first(0);
  const VisitId end(table_.visits());
  for (const VisitId k : table_.all_visits())
    for (const ArmId arm : choices(k)) {
      if (k != first)
        used.try_emplace(arm, context_).first->second.push_back(at(k, arm) && told(k.previous()));
      if (k.next() != end)
        used.try_emplace(table_.left(k, arm), context_)
            .first->second.push_back(at(k, arm) && told(k.next()));
    }
  for (const auto& [arm, by] : used) {
    const z3::expr has = context_.bool_const(("segment_" + std::to_string(arm.index())).c_str());
    solver_.add(has == z3::mk_or(by));
    has_segment_.push_back(has);
  }
  return has_segment_;
}

z3::expr FreeAssociation::at_most(const std::vector<std::pair<z3::expr, int>>& sum, int bound) {
  z3::expr_vector terms(context_);
  std::vector<int> weights;
  for (const auto& [term, weight] : sum) {
    terms.push_back(term);
    weights.push_back(weight);
  }
  if (bound < 0) return context_.bool_val(false);
  if (sum.empty()) return context_.bool_val(true);
  return z3::pble(terms, weights.data(), bound);
}

z3::expr FreeAssociation::at_least_places(std::size_t count) {
  std::vector<std::pair<z3::expr, int>> sum;
  for (const VisitId k : table_.all_visits()) sum.emplace_back(is_new(k), 1);
  return !at_most(sum, static_cast<int>(count) - 1);
}

z3::expr FreeAssociation::at_least_paths(std::size_t count) {
  // 2 |paths| = Σ new(k) arms(k) − Σ has_segment, and −x = ¬x − 1.
  std::vector<std::pair<z3::expr, int>> sum;
  for (const VisitId k : table_.all_visits())
    sum.emplace_back(is_new(k), static_cast<int>(table_.star_size(k)));
  for (const z3::expr& has : has_segment()) sum.emplace_back(!has, 1);
  return !at_most(sum, 2 * (static_cast<int>(count) - 1) + static_cast<int>(has_segment().size()));
}

z3::expr FreeAssociation::at_least_segments(std::size_t count) {
  std::vector<std::pair<z3::expr, int>> sum;
  for (const z3::expr& has : has_segment()) sum.emplace_back(has, 1);
  // An even number of gateways: more than 2 (count − 1) are 2 count.
  return !at_most(sum, 2 * (static_cast<int>(count) - 1));
}

std::vector<ArmId> FreeAssociation::named(const z3::model& model) const {
  std::vector<ArmId> named(at_.size(), no_arm);
  for (const VisitId k : table_.all_visits())
    for (const ArmId arm : choices(k))
      if (model.eval(at(k, arm), true).is_true()) named[k.index()] = arm;
  return named;
}

}  // namespace asterism
