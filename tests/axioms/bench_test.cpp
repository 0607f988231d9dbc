#include <algorithm>
#include <optional>
#include <vector>

#include "axioms/bench/guarded.hpp"
#include "axioms/bench/spare.hpp"
#include "axioms/bench/z3.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

using Numbers = std::vector<int>;

constexpr unsigned timeout_ms = 10'000;

/// 1 and 2 cannot be together, nor can 3 and 5.
std::optional<Numbers> all_of_a_conflict(const Numbers& some) {
  const auto has = [&](int number) { return std::ranges::find(some, number) != some.end(); };
  return (has(1) && has(2)) || (has(3) && has(5)) ? std::optional(some) : std::nullopt;
}

TEST_CASE("of a conflict stays what cannot be spared, the last of the order first",
          "[axioms][bench]") {
  const Numbers members{1, 2, 3, 4, 5, 6};
  const Numbers backwards{members.rbegin(), members.rend()};
  CHECK(spare_one_by_one(members, members, all_of_a_conflict) == Numbers{3, 5});
  CHECK(spare_one_by_one(members, backwards, all_of_a_conflict) == Numbers{1, 2});
}

TEST_CASE("what a smaller conflict leaves out is not asked about", "[axioms][bench]") {
  const Numbers members{1, 2, 3, 4, 5, 6};
  int questions = 0;
  const auto conflict = [&](const Numbers& some) -> std::optional<Numbers> {
    ++questions;
    return all_of_a_conflict(some) ? std::optional(Numbers{3, 5}) : std::nullopt;
  };
  CHECK(spare_one_by_one(members, members, conflict) == Numbers{3, 5});
  CHECK(questions == 3);  // without 1, without 3, without 5
}

TEST_CASE("formulas that cannot be together are found and confirmed", "[axioms][bench]") {
  z3::context context;
  const z3::expr p = context.bool_const("p");
  const z3::expr q = context.bool_const("q");
  const z3::expr r = context.bool_const("r");
  GuardedFormulas formulas(context);
  for (const z3::expr& formula : {r, p, r || p, z3::implies(p, q)}) formulas.add(formula);
  CHECK_FALSE(formulas.irredundant_core(timeout_ms));
  formulas.grant(!q);
  const auto core = formulas.irredundant_core(timeout_ms);
  REQUIRE(core);
  CHECK(*core == GuardedFormulas::Numbers{1, 3});
  CHECK_NOTHROW(formulas.confirm(*core, timeout_ms));
  CHECK_THROWS_AS(formulas.confirm(std::vector<std::size_t>{0, 1, 2}, timeout_ms), SolverError);
}

}  // namespace
}  // namespace asterism
