#include "mapping/comparing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asterism {
namespace {

/// Of a trace; without some axioms there are more.
constexpr std::uint64_t max_hypotheses = 1000;

}  // namespace

MapTree::Options verify_tree_options(const Theory& theory, Check check) {
  return {.theory = theory, .check = check, .max_hypotheses = max_hypotheses};
}

std::vector<Association> associations_of(const MapTree& tree) {
  std::vector<Association> result;
  tree.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    result.emplace_back(arrivals.begin(), arrivals.end());
  });
  std::ranges::sort(result);
  return result;
}

std::string why_undecided(const MapTree& tree, Deadline deadline) {
  if (is_over(deadline)) return by_time_limit;
  return fmt::format("{} candidates undecided by the solver", tree.undecided());
}

}  // namespace asterism
