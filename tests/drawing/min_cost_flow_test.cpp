#include "drawing/min_cost_flow.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("the cheapest flow assigns as well as the best permutation", "[planarity][property]") {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    constexpr std::size_t n = 5;
    std::vector<FlowArc> arcs;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        arcs.push_back({i, n + j, 1, static_cast<long>(random() % 20) - 5});
    std::vector<long> supply(n, 1);
    supply.resize(2 * n, -1);
    const Flow flow = cheapest_flow(arcs, supply, std::vector<long>(2 * n, 0));

    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    long best = 1000;
    do {
      long cost = 0;
      for (std::size_t i = 0; i < n; ++i) cost += arcs[n * i + order[i]].cost;
      best = std::min(best, cost);
    } while (std::next_permutation(order.begin(), order.end()));
    CHECK(flow.cost == best);
    for (std::size_t a = 0; a < arcs.size(); ++a) {
      const long reduced = arcs[a].cost + flow.potential[arcs[a].from] - flow.potential[arcs[a].to];
      CHECK((reduced >= 0 || flow.units[a] == 1));
      CHECK((reduced <= 0 || flow.units[a] == 0));
    }
  }
}

TEST_CASE("supplies that no arc can carry are refused", "[planarity]") {
  CHECK_THROWS_AS(cheapest_flow({{0, 1, 1, 0}}, {2, -2}, {0, 0}), std::logic_error);
}
