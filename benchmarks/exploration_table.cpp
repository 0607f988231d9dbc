#include "benchmarks/exploration_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "benchmarks/exploration.hpp"

namespace asterism {
namespace {

constexpr std::size_t explored_travels = 10;

struct Way {
  const char* name;
  Explorer explorer;
  std::size_t advised_travels;  ///< of an exit
};
constexpr Way random_way{"random gateways", Explorer::random, 0};
constexpr Way nearest_way{"nearest unexplored gateway", Explorer::nearest_unexplored, 0};
constexpr Way advised_ways[] = {
    {"advice, exits up to 1 travel away", Explorer::advised, 1},
    {"advice, up to 3 (default)", Explorer::advised, ExitBounds{}.travels},
    {"advice, up to 6", Explorer::advised, 6},
};

/// A seed draws the world and the walk, and the chances of the random explorer.
struct Start {
  std::uint64_t seed;
  Exploration exploration;
};

std::vector<Start> starts(std::size_t worlds) {
  std::vector<Start> result;
  for (std::uint64_t seed = 0; result.size() < worlds; ++seed)
    if (auto drawn = exploration(seed)) result.push_back({seed, *std::move(drawn)});
  return result;
}

std::vector<Explored> explore_all(const std::vector<Start>& starts, const Way& way, bool planar) {
  std::vector<Explored> result;
  for (const Start& start : starts) {
    RandomEngine engine(start.seed);
    result.push_back(explore(start.exploration, way.explorer, planar, explored_travels, engine,
                             {.travels = way.advised_travels}));
  }
  return result;
}

template <class F>
double mean(const std::vector<Explored>& all, F&& of) {
  double sum = 0;
  for (const Explored& one : all) sum += of(one);
  return sum / static_cast<double>(all.size());
}

std::string share_text(const std::vector<Explored>& ours, const std::vector<Explored>& theirs) {
  const auto [log_ratio, half_width] = mean_log_ratio(ours, theirs);
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", std::exp(log_ratio),
                     std::exp(log_ratio - half_width), std::exp(log_ratio + half_width));
}

void add_row(Report& report, const Way& way, bool planar, const std::vector<Explored>& all,
             const std::string& share_of_random, const std::string& share_of_nearest) {
  const auto number = [&](auto part) {
    return fmt::format(
        "{:.1f}", mean(all, [&](const Explored& one) { return static_cast<double>(one.*part); }));
  };
  const double log_maps =
      mean(all, [](const Explored& one) { return std::log(static_cast<double>(one.maps)); });
  report.add_row({fmt::format("{}{}", way.name, planar ? ", planar" : ""),
                  count_text(static_cast<std::uint64_t>(std::llround(std::exp(log_maps)))),
                  share_of_random, share_of_nearest, number(&Explored::places),
                  number(&Explored::segments), number(&Explored::new_segments)});
}

}  // namespace

void add_exploration_table(Report& report, std::size_t worlds) {
  report.begin_table(
      fmt::format("Ten travels further, in {} simulated worlds: the maps then left, by the "
                  "geometric mean, as a share of what others leave (95 %), and what was seen on "
                  "these travels:",
                  worlds),
      {"the robot goes by", "maps left", "of random", "of nearest", "places", "segments",
       "new segments"});
  const std::vector<Start> drawn = starts(worlds);
  for (const bool planar : {false, true}) {
    const std::vector<Explored> random = explore_all(drawn, random_way, planar);
    const std::vector<Explored> nearest = explore_all(drawn, nearest_way, planar);
    add_row(report, random_way, planar, random, "", "");
    add_row(report, nearest_way, planar, nearest, share_text(nearest, random), "");
    for (const Way& way : advised_ways) {
      const std::vector<Explored> advised = explore_all(drawn, way, planar);
      add_row(report, way, planar, advised, share_text(advised, random),
              share_text(advised, nearest));
    }
  }
}

}  // namespace asterism
