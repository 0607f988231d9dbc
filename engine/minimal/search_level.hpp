#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "core/search_state.hpp"
#include "core/stop.hpp"
#include "engine/preference.hpp"

namespace asterism {

inline constexpr Preference::Rank no_rank = UINT64_MAX;

/// What the workers share: the level in work, what was found, and branches to take over.
class SearchLevel {
 public:
  /// What is preferred less than this is left out.
  Preference::Rank limit() const { return limit_.load(std::memory_order_relaxed); }

  void refuse(Preference::Rank rank) {
    Preference::Rank refused = refused_.load(std::memory_order_relaxed);
    while (rank < refused &&
           !refused_.compare_exchange_weak(refused, rank, std::memory_order_relaxed)) {
    }
  }
  void found(Preference::Rank rank, SearchState::Model model) {
    const std::lock_guard lock(mutex_);
    if (rank > limit()) return;
    if (models.empty() || rank < best) {
      models.clear();
      best = rank;
      limit_ = rank;
    }
    models.push_back(std::move(model));
  }

  /// A map of this rank is known from elsewhere.
  void lower(Preference::Rank limit) {
    if (models.empty() && limit < limit_) limit_ = limit;
  }
  void begin(Preference::Rank limit) {
    limit_ = limit;
    refused_ = no_rank;
    best = no_rank;
    models.clear();
    branches.clear();
  }
  Preference::Rank refused() const { return refused_; }
  void resume(const SearchState& state, Preference::Rank rank) {
    begin(state.limit);
    refused_ = state.refused;
    models = state.models;
    best = rank;
    branches.assign(state.branches.begin(), state.branches.end());
  }

  /// Whether a worker waits for something to do.
  bool is_hungry() const { return hungry_.load(std::memory_order_relaxed); }
  bool is_stopped() const { return stopped_.load(std::memory_order_relaxed); }

  void give(SearchState::Branch branch) {
    const std::lock_guard lock(mutex_);
    branches.push_back(std::move(branch));
    hungry_ = waiting_ > branches.size();
    wake_.notify_one();
  }
  /// Waits until there is something to do, unless all wait, or it is to end.
  std::optional<SearchState::Branch> take() {
    std::unique_lock lock(mutex_);
    ++waiting_;
    if (waiting_ == workers_ && branches.empty()) stop_locked();
    hungry_ = waiting_ > branches.size();
    wake_.wait(lock, [&] { return is_stopped() || !branches.empty(); });
    --waiting_;
    if (is_stopped()) return std::nullopt;
    SearchState::Branch branch = std::move(branches.front());
    branches.pop_front();
    hungry_ = waiting_ > branches.size();
    return branch;
  }
  /// Whether the slice is over.
  bool is_due() const { return is_over(until_); }
  void start(unsigned workers, Deadline until) {
    until_ = until;
    workers_ = workers;
    waiting_ = 0;
    stopped_ = false;
    hungry_ = false;
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    stop_locked();
  }

  std::vector<SearchState::Model> models;  ///< of rank `best`
  Preference::Rank best = no_rank;
  std::deque<SearchState::Branch> branches;

 private:
  void stop_locked() {
    stopped_ = true;
    wake_.notify_all();
  }

  std::atomic<Preference::Rank> limit_ = 0;
  std::atomic<Preference::Rank> refused_ = no_rank;
  std::mutex mutex_;
  std::condition_variable wake_;
  Deadline until_ = Deadline::max();
  unsigned workers_ = 1;
  unsigned waiting_ = 0;
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> hungry_ = false;
};

}  // namespace asterism
