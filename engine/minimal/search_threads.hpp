#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/search_state.hpp"
#include "engine/arm_table.hpp"
#include "engine/minimal/folding.hpp"
#include "engine/minimal/search_level.hpp"
#include "engine/minimal/search_worker.hpp"
#include "engine/preference.hpp"

namespace asterism {

/// How long is searched between questions to the caller.
inline constexpr double slice_s = 0.02;

/// The workers of a search for minimal models, on as many threads as are asked for.
///
/// A thread has two workers, which take turns: one begins where the other would come to last, and
/// a good map, found by either, shows both what to leave out.
class SearchThreads {
 public:
  SearchThreads(const ArmTable& table, const Preference& preference, SearchLevel& level)
      : table_(table), preference_(preference), level_(level) {}

  /// Searches the level on, for a slice of time.
  /// @return whether it has been searched to its end
  bool work(const Folding& begun, unsigned jobs);

  /// Whether what was decided holds, in each of these.
  bool hold(const std::deque<SearchState::Branch>& branches, const Folding& begun);

  /// Of this trace no more.
  void forget();
  /// All that is yet to be tried by them.
  void add_branches(std::vector<SearchState::Branch>& branches) const;
  /// So far, by all of them, those forgotten too.
  std::uint64_t branchings() const;
  std::size_t memory_bytes() const;

 private:
  void make(std::size_t count, const Folding& begun);
  void take_turns(std::span<SearchWorker> ends, std::uint64_t most_steps);

  const ArmTable& table_;
  const Preference& preference_;
  SearchLevel& level_;
  std::vector<SearchWorker> workers_;
  std::uint64_t branchings_before_ = 0;
};

}  // namespace asterism
