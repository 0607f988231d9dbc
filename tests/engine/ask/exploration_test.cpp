#include "benchmarks/exploration.hpp"

#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

constexpr std::size_t worlds = 100;
constexpr std::size_t travels = 10;
constexpr double log_of_0_8 = -0.2231;

std::vector<Explored> explore_all(Explorer explorer, bool planar) {
  std::vector<Explored> all;
  for (std::uint64_t seed = 0; all.size() < worlds; ++seed) {
    const auto start = exploration(seed);
    if (!start) continue;
    RandomEngine engine(seed);
    all.push_back(explore(*start, explorer, planar, travels, engine));
  }
  return all;
}

std::size_t segments(const std::vector<Explored>& all) {
  std::size_t sum = 0;
  for (const Explored& one : all) sum += one.segments;
  return sum;
}

}  // namespace

TEST_CASE("who follows the advice is left with fewer maps", "[engine][exits][simulation]") {
  const bool planar = GENERATE(false, true);
  const std::vector<Explored> advised = explore_all(Explorer::advised, planar);
  const std::vector<Explored> random = explore_all(Explorer::random, planar);
  const std::vector<Explored> nearest = explore_all(Explorer::nearest_unexplored, planar);
  for (const std::vector<Explored>& others : {random, nearest}) {
    const auto [mean, half_width] = mean_log_ratio(advised, others);
    CHECK(mean < log_of_0_8);
    CHECK(mean + half_width < 0);
  }
  // Not by going to and fro.
  CHECK(segments(advised) > segments(random));
}
