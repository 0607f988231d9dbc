#include "engine/proof/claim_circuit.hpp"

#include <array>

namespace asterism {
namespace {

std::vector<VisitId> mentions(const Claim::Number& number) {
  if (const auto* steps = std::get_if<Claim::Steps>(&number)) return {steps->from, steps->to};
  return {};
}

}  // namespace

z3::expr ClaimCircuit::any(const std::vector<z3::expr>& parts) const {
  z3::expr_vector list(association_.context());
  for (const z3::expr& part : parts) list.push_back(part);
  return z3::mk_or(list);
}

/// A name for a formula, so that what is built on it stays small.
z3::expr ClaimCircuit::named(const z3::expr& formula) {
  const z3::expr name =
      association_.context().bool_const(("part_" + std::to_string(names_++)).c_str());
  solver_.add(name == formula);
  return name;
}

z3::expr ClaimCircuit::free_unless_told(const std::vector<VisitId>& visits,
                                        const z3::expr& statement) {
  z3::context& context = association_.context();
  z3::expr_vector told(context);
  for (const VisitId visit : visits) told.push_back(association_.told(visit));
  const z3::expr name = context.bool_const(("statement_" + std::to_string(statements_++)).c_str());
  solver_.add(z3::implies(z3::mk_and(told), name == statement));
  return name;
}

z3::expr ClaimCircuit::adjacent(VisitId i, VisitId j) {
  std::vector<z3::expr> ways;
  for (const VisitId k : IdRange(VisitId(1), VisitId(visits())))
    for (const auto& [here, there] : {std::pair(i, j), std::pair(j, i)})
      ways.push_back(association_.same(here, k.previous()) && association_.same(there, k));
  return any(ways);
}

/// Of each visit, whether its place is so near that of `from`.
std::vector<z3::expr> ClaimCircuit::within_steps(VisitId from, std::size_t steps) {
  std::vector<z3::expr> near;
  for (const VisitId k : IdRange<VisitId>(visits())) near.push_back(association_.same(from, k));
  for (std::size_t step = 0; step < steps; ++step) {
    std::vector<z3::expr> nearer = near;
    for (std::size_t k = 0; k < visits(); ++k) {
      std::vector<z3::expr> ways{near[k]};
      for (std::size_t m = 0; m < visits(); ++m) {
        std::vector<z3::expr> neighbours;
        if (m > 0) neighbours.push_back(near[m - 1]);
        if (m + 1 < visits()) neighbours.push_back(near[m + 1]);
        ways.push_back(association_.same(VisitId(m), VisitId(k)) && any(neighbours));
      }
      nearer[k] = any(ways);
    }
    near = std::move(nearer);
  }
  return near;
}

/// No number gets larger.
std::uint64_t ClaimCircuit::most(const Claim::Number& number) const {
  return std::visit(Overloaded{[](std::uint64_t given) { return given; },
                               [&](Extent extent) -> std::uint64_t {
                                 return extent == Extent::path ? association_.table().size()
                                                               : visits();
                               },
                               [&](const Claim::Steps&) -> std::uint64_t { return visits(); }},
                    number);
}

z3::expr ClaimCircuit::is_at_least(const Claim::Number& number, std::uint64_t bound) {
  z3::context& context = association_.context();
  if (bound == 0) return context.bool_val(true);
  if (bound > most(number)) return context.bool_val(false);
  const auto count = static_cast<std::size_t>(bound);
  return std::visit(Overloaded{[&](std::uint64_t) { return context.bool_val(true); },
                               [&](Extent extent) {
                                 return extent == Extent::place
                                            ? association_.at_least_places(count)
                                        : extent == Extent::path
                                            ? association_.at_least_paths(count)
                                            : association_.at_least_segments(count);
                               },
                               [&](const Claim::Steps& steps) {
                                 return !within_steps(steps.from, count - 1)[steps.to.index()];
                               }},
                    number);
}

z3::expr ClaimCircuit::is_less(const Claim::Number& one, const Claim::Number& other) {
  if (const auto* given = std::get_if<std::uint64_t>(&one)) return is_at_least(other, *given + 1);
  if (const auto* given = std::get_if<std::uint64_t>(&other)) return !is_at_least(one, *given);
  std::vector<z3::expr> ways;
  for (std::uint64_t bound = 1; bound <= most(other); ++bound)
    ways.push_back(!is_at_least(one, bound) && is_at_least(other, bound));
  return any(ways);
}

z3::expr ClaimCircuit::comparison(const Claim::Comparison& comparison) {
  const auto less = [&] { return is_less(comparison.left, comparison.right); };
  const auto greater = [&] { return is_less(comparison.right, comparison.left); };
  switch (comparison.relation) {
    case Claim::Relation::equal:
      return !less() && !greater();
    case Claim::Relation::not_equal:
      return less() || greater();
    case Claim::Relation::less:
      return less();
    case Claim::Relation::at_most:
      return !greater();
    case Claim::Relation::greater:
      return greater();
    case Claim::Relation::at_least:
      break;
  }
  return !less();
}

// A path is walked travel by travel. Travel k leads from visit k - 1 to visit k; node k - 1 is this
// travel forwards, node visits - 1 + k - 1 backwards.

ClaimCircuit::OwnArm ClaimCircuit::left_end(VisitId to) const {
  const VisitId from = to.previous();
  return {from, *visit(from).left_by};
}

ClaimCircuit::OwnArm ClaimCircuit::entered_end(VisitId to) const {
  return {to, *visit(to).entered_by};
}

ClaimCircuit::OwnArm ClaimCircuit::opposite(OwnArm own) const {
  return {own.visit, visit(own.visit).star.opposite(own.arm)};
}

ClaimCircuit::OwnArm ClaimCircuit::from(std::size_t node) const {
  const std::size_t travels = visits() - 1;
  return node < travels ? left_end(VisitId(node + 1)) : entered_end(VisitId(node - travels + 1));
}

ClaimCircuit::OwnArm ClaimCircuit::to(std::size_t node) const {
  const std::size_t travels = visits() - 1;
  return node < travels ? entered_end(VisitId(node + 1)) : left_end(VisitId(node - travels + 1));
}

/// Of each travel in a direction, those that one comes out of who goes straight on into it.
const std::vector<std::vector<ClaimCircuit::Before>>& ClaimCircuit::before() {
  const std::size_t nodes = 2 * (visits() - 1);
  for (std::size_t b = before_.size(); b < nodes; ++b) {
    before_.emplace_back();
    for (std::size_t a = 0; a < nodes; ++a) {
      const z3::expr meet = association_.coincide(opposite(to(a)), from(b));
      if (!meet.is_false())
        before_[b].push_back({a, named(meet && association_.told(to(b).visit))});
    }
  }
  return before_;
}

/// The travels, each in a direction, that one goes along who leaves by one of these arms and stays
/// on its path.
ClaimCircuit::Reached ClaimCircuit::along(std::span<const OwnArm> starts) {
  const std::size_t nodes = 2 * (visits() - 1);
  Reached reached;
  for (std::size_t node = 0; node < nodes; ++node) {
    std::vector<z3::expr> ways;
    for (const OwnArm start : starts) ways.push_back(association_.coincide(start, from(node)));
    reached.push_back(any(ways) && association_.told(to(node).visit));
  }
  for (std::size_t step = 1; step + 1 < visits(); ++step) {
    Reached further;
    for (std::size_t node = 0; node < nodes; ++node) {
      std::vector<z3::expr> ways{reached[node]};
      for (const auto& [other, meet] : before()[node]) ways.push_back(reached[other] && meet);
      further.push_back(named(any(ways)));
    }
    reached = std::move(further);
  }
  return reached;
}

z3::expr ClaimCircuit::comes_by(const Reached& reached, VisitId visit) {
  std::vector<z3::expr> ways;
  for (std::size_t node = 0; node < reached.size(); ++node)
    ways.push_back(reached[node] && association_.same(visit, to(node).visit));
  return any(ways);
}

z3::expr ClaimCircuit::on(VisitId visit, VisitId path_of) {
  const OwnArm left{path_of, *this->visit(path_of).left_by};
  return association_.same(visit, path_of) ||
         comes_by(along(std::array{left, opposite(left)}), visit);
}

z3::expr ClaimCircuit::on_path(VisitId i, VisitId j) {
  std::vector<OwnArm> arms;
  for (std::size_t arm = 0; arm < association_.table().star_size(i); ++arm)
    arms.push_back({i, arm});
  return association_.same(i, j) || comes_by(along(arms), j);
}

z3::expr ClaimCircuit::order(VisitId i, VisitId j, VisitId k) {
  std::vector<Reached> reached;
  for (std::size_t arm = 0; arm < association_.table().star_size(j); ++arm)
    reached.push_back(along(std::array{OwnArm{j, arm}}));
  std::vector<z3::expr> ways;
  for (std::size_t arm = 0; arm < reached.size(); ++arm)
    ways.push_back(comes_by(reached[arm], i) && comes_by(reached[opposite({j, arm}).arm], k));
  return any(ways);
}

z3::expr ClaimCircuit::same_path(VisitId i, VisitId j) {
  const auto left = [&](VisitId k) { return OwnArm{k, *visit(k).left_by}; };
  const auto is_along = [&](OwnArm arm) {  // or along its other direction
    return association_.coincide(left(i), arm) || association_.coincide(left(i), opposite(arm));
  };
  std::vector<z3::expr> ways{is_along(left(j))};
  const Reached reached = along(std::array{left(j), opposite(left(j))});
  for (std::size_t node = 0; node < reached.size(); ++node)
    ways.push_back(reached[node] && is_along(to(node)));
  return any(ways);
}

z3::expr ClaimCircuit::formula(const Claim& claim) {
  z3::context& context = association_.context();
  const auto parts = [&](const std::vector<Claim>& claims) {
    z3::expr_vector formulas(context);
    for (const Claim& part : claims) formulas.push_back(formula(part));
    return formulas;
  };
  return std::visit(
      Overloaded{
          [&](const Claim::All& all) { return z3::mk_and(parts(all.parts)); },
          [&](const Claim::Any& any) { return z3::mk_or(parts(any.parts)); },
          [&](const Claim::Not& negation) { return !formula(negation.part.front()); },
          [&](const Claim::Same& same) {
            return free_unless_told({same.one, same.other},
                                    association_.same(same.one, same.other));
          },
          [&](const Claim::Adjacent& said) {
            return free_unless_told({said.one, said.other}, adjacent(said.one, said.other));
          },
          [&](const Claim::On& said) {
            return free_unless_told({said.visit, said.path_of}, on(said.visit, said.path_of));
          },
          [&](const Claim::OnPath& said) {
            return free_unless_told({said.one, said.other}, on_path(said.one, said.other));
          },
          [&](const Claim::Order& said) {
            return free_unless_told({said.first, said.second, said.third},
                                    order(said.first, said.second, said.third));
          },
          [&](const Claim::SamePath& said) {
            return free_unless_told({said.path_of, said.other_path_of},
                                    same_path(said.path_of, said.other_path_of));
          },
          [&](const Claim::Comparison& said) {
            std::vector<VisitId> visits = mentions(said.left);
            for (const VisitId visit : mentions(said.right)) visits.push_back(visit);
            return free_unless_told(visits, comparison(said));
          }},
      claim.is);
}

}  // namespace asterism
