#include "drawing/min_cost_flow.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

namespace asterism {
namespace {

constexpr long unreached = std::numeric_limits<long>::max();

/// Arc a of the problem is residual arcs 2a and 2a + 1, its reverse.
class Network {
 public:
  Network(const std::vector<FlowArc>& arcs, std::vector<long> supply, std::vector<long> potential)
      : supply_(std::move(supply)), potential_(std::move(potential)), leaving_(supply_.size()) {
    for (const auto& [from, to, capacity, cost] : arcs) {
      const bool is_full = cost + potential_[from] - potential_[to] < 0;
      leaving_[from].push_back(residual_.size());
      residual_.push_back({to, is_full ? 0 : capacity, cost});
      leaving_[to].push_back(residual_.size());
      residual_.push_back({from, is_full ? capacity : 0, -cost});
      if (is_full) supply_[from] -= capacity;
      if (is_full) supply_[to] += capacity;
    }
  }

  Flow solve() {
    while (std::any_of(supply_.begin(), supply_.end(), [](long units) { return units > 0; })) {
      raise_potentials();
      augment();
    }
    Flow flow{{}, potential_, 0};
    for (std::size_t a = 0; a < residual_.size(); a += 2) {
      flow.units.push_back(residual_[a + 1].capacity);
      flow.cost += residual_[a].cost * residual_[a + 1].capacity;
    }
    return flow;
  }

 private:
  struct Residual {
    std::size_t to;
    long capacity;
    long cost;
  };

  long reduced_cost(std::size_t from, const Residual& arc) const {
    return arc.cost + potential_[from] - potential_[arc.to];
  }

  /// After this, the shortest ways from supplies to demands have reduced cost 0.
  void raise_potentials() {
    using Entry = std::pair<long, std::size_t>;
    std::vector<long> distance(supply_.size(), unreached);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t v = 0; v < supply_.size(); ++v)
      if (supply_[v] > 0) queue.emplace(distance[v] = 0, v);
    long nearest_demand = unreached;
    while (!queue.empty()) {
      const auto [length, v] = queue.top();
      queue.pop();
      if (length > distance[v]) continue;
      if (supply_[v] < 0) nearest_demand = std::min(nearest_demand, length);
      for (const std::size_t a : leaving_[v]) {
        const Residual& arc = residual_[a];
        if (arc.capacity == 0) continue;
        const long through = length + reduced_cost(v, arc);
        if (through < distance[arc.to]) queue.emplace(distance[arc.to] = through, arc.to);
      }
    }
    if (nearest_demand == unreached) throw std::logic_error("no flow meets the supplies");
    for (std::size_t v = 0; v < supply_.size(); ++v)
      potential_[v] += std::min(distance[v], nearest_demand);
  }

  void augment() {
    visited_.assign(supply_.size(), false);
    for (std::size_t v = 0; v < supply_.size(); ++v) {
      while (supply_[v] > 0) {
        const long pushed = push(v, supply_[v]);
        if (pushed == 0) break;
        supply_[v] -= pushed;
      }
    }
  }

  /// Sends up to `units` from v to some demand along arcs of reduced cost 0; how many went.
  long push(std::size_t v, long units) {
    if (supply_[v] < 0) {
      const long taken = std::min(units, -supply_[v]);
      supply_[v] += taken;
      return taken;
    }
    if (visited_[v]) return 0;
    visited_[v] = true;
    for (const std::size_t a : leaving_[v]) {
      Residual& arc = residual_[a];
      if (arc.capacity == 0 || reduced_cost(v, arc) != 0) continue;
      const long pushed = push(arc.to, std::min(units, arc.capacity));
      if (pushed == 0) continue;
      arc.capacity -= pushed;
      residual_[a ^ 1].capacity += pushed;
      visited_[v] = false;  // it leads on: worth coming here again
      return pushed;
    }
    return 0;
  }

  std::vector<long> supply_;
  std::vector<long> potential_;
  std::vector<std::vector<std::size_t>> leaving_;
  std::vector<Residual> residual_;
  std::vector<bool> visited_;
};

}  // namespace

Flow cheapest_flow(const std::vector<FlowArc>& arcs, std::vector<long> supply,
                   std::vector<long> potential) {
  return Network(arcs, std::move(supply), std::move(potential)).solve();
}

}  // namespace asterism
