#include "engine/free_association.hpp"

#include <algorithm>

namespace asterism {
namespace {

std::string name(const char* what, std::size_t one, std::size_t other) {
  return what + ("_" + std::to_string(one)) + "_" + std::to_string(other);
}

}  // namespace

FreeAssociation::FreeAssociation(z3::context& context, z3::solver& solver, const ArmTable& table)
    : context_(context), solver_(solver), table_(table), at_(table.visits()) {
  for (std::size_t k = 0; k < table.visits(); ++k) {
    told_.push_back(context.bool_const(("told_" + std::to_string(k)).c_str()));
    for (const ArmIndex arm : choices(k)) {
      at_[k].push_back(context.bool_const(name("at", k, arm).c_str()));
      const std::size_t place = table.visit_of(arm);
      if (place != k) solver.add(z3::implies(at_[k].back(), is_new(place)));
      solver.add(z3::implies(at_[k].back(), told_[k]));
    }
  }
}

void FreeAssociation::choose(std::size_t k) {
  z3::expr_vector one(context_);
  for (const z3::expr& choice : at_[k]) one.push_back(choice);
  solver_.add(z3::implies(told_[k], z3::mk_or(one)));
  solver_.add(z3::atmost(one, 1));
}

z3::expr FreeAssociation::at(std::size_t k, ArmIndex arm) const {
  return table_.visit_of(arm) == k ? is_new(k) : at_[k][arm];
}

std::vector<ArmIndex> FreeAssociation::choices(std::size_t k) const {
  std::vector<ArmIndex> arms;
  for (ArmIndex arm = 0; arm < table_.first_arm(k); ++arm) arms.push_back(arm);
  arms.push_back(table_.entered(k));
  return arms;
}

z3::expr FreeAssociation::here(std::size_t k, std::size_t first_visit) const {
  if (k == first_visit) return is_new(k);
  z3::expr_vector arms(context_);
  const ArmIndex first = table_.first_arm(first_visit);
  for (ArmIndex arm = first; arm < first + table_.star_size(first_visit); ++arm)
    arms.push_back(at_[k][arm]);
  return z3::mk_or(arms);
}

z3::expr FreeAssociation::same(std::size_t i, std::size_t j) {
  if (i == j) return told(i);
  const auto [earlier, later] = std::minmax(i, j);
  const auto known = same_.find({earlier, later});
  if (known != same_.end()) return known->second;
  z3::expr_vector places(context_);
  for (std::size_t first = 0; first <= earlier; ++first)
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
    const ArmIndex size = table_.star_size(own.visit);
    const ArmIndex entered = table_.entered(own.visit) - table_.first_arm(own.visit);
    return (static_cast<ArmIndex>(own.arm) + size - entered) % size;
  };
  z3::expr_vector ways(context_);
  for (const ArmIndex arm : choices(one.visit)) {
    const ArmIndex place = table_.visit_of(arm);
    const ArmIndex meant = table_.clockwise(arm, steps(one) % table_.star_size(place));
    const ArmIndex first = table_.first_arm(place);
    for (ArmIndex entered = first; entered < first + table_.star_size(place); ++entered)
      if (table_.clockwise(entered, steps(other) % table_.star_size(place)) == meant)
        ways.push_back(at(one.visit, arm) && at(other.visit, entered));
  }
  return z3::mk_or(ways);
}

z3::expr FreeAssociation::linked(ArmIndex one, ArmIndex other) {
  if (one > other) std::swap(one, other);
  const auto known = linked_.find({one, other});
  if (known != linked_.end()) return known->second;
  const z3::expr linked = context_.bool_const(name("linked", one, other).c_str());
  for (std::size_t k = 1; k < table_.visits(); ++k)
    for (const ArmIndex entered : {one, other}) {
      const ArmIndex left = entered == one ? other : one;
      if (table_.visit_of(entered) > k || table_.visit_of(left) > k - 1) continue;
      if (table_.visit_of(entered) == k && entered != table_.entered(k)) continue;
      for (const ArmIndex before : choices(k - 1))
        if (table_.left(k - 1, before) == left)
          solver_.add(z3::implies(at(k - 1, before) && at(k, entered), linked));
    }
  return linked_.emplace(std::pair(one, other), linked).first->second;
}

const std::vector<z3::expr>& FreeAssociation::has_segment() {
  if (!has_segment_.empty()) return has_segment_;
  std::map<ArmIndex, z3::expr_vector> used;  // by what a gateway gets a segment
  const std::size_t visits = table_.visits();
  for (std::size_t k = 0; k < visits; ++k)
    for (const ArmIndex arm : choices(k)) {
      if (k > 0) used.try_emplace(arm, context_).first->second.push_back(at(k, arm) && told(k - 1));
      if (k + 1 < visits)
        used.try_emplace(table_.left(k, arm), context_)
            .first->second.push_back(at(k, arm) && told(k + 1));
    }
  for (const auto& [arm, by] : used) {
    const z3::expr has = context_.bool_const(("segment_" + std::to_string(arm)).c_str());
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
  for (std::size_t k = 0; k < table_.visits(); ++k) sum.emplace_back(is_new(k), 1);
  return !at_most(sum, static_cast<int>(count) - 1);
}

z3::expr FreeAssociation::at_least_paths(std::size_t count) {
  // 2 |paths| = Σ new(k) arms(k) − Σ has_segment, and −x = ¬x − 1.
  std::vector<std::pair<z3::expr, int>> sum;
  for (std::size_t k = 0; k < table_.visits(); ++k)
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

std::vector<ArmIndex> FreeAssociation::named(const z3::model& model) const {
  std::vector<ArmIndex> named(at_.size(), untold);
  for (std::size_t k = 0; k < at_.size(); ++k)
    for (const ArmIndex arm : choices(k))
      if (model.eval(at(k, arm), true).is_true()) named[k] = arm;
  return named;
}

}  // namespace asterism
