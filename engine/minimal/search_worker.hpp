#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/id_vector.hpp"
#include "core/random.hpp"
#include "core/search_state.hpp"
#include "engine/arm_table.hpp"
#include "engine/minimal/folding.hpp"
#include "engine/minimal/search_level.hpp"
#include "engine/preference.hpp"

namespace asterism {

/// One thread of a search for minimal models, depth first.
class SearchWorker {
 public:
  /// @param begun  of this trace, nothing settled
  SearchWorker(const ArmTable& table, const Preference& preference, const Folding& begun,
               SearchLevel& level);

  bool is_idle() const { return frames_.empty(); }
  std::uint64_t branchings() const { return branchings_; }
  std::size_t memory_bytes() const { return folding_.memory_bytes(); }

  /// @return false if what was decided contradicts itself
  bool take(const SearchState::Branch& branch);
  void clear();

  /// Tries what is next.
  /// @pre  it is not idle
  void advance();

  /// Tries the map in which no two places are one that need not be.
  void stand_apart();
  /// From now on tries candidates in random order, and if told so, what hangs on settled places
  /// before all else: to come upon some map, not to see all.
  void wander(std::uint64_t seed, bool from_settled);

  /// Parts with the branch nearest to the root, if it keeps another.
  std::optional<SearchState::Branch> give();
  /// All that is yet to be tried.
  void add_branches(std::vector<SearchState::Branch>& branches) const;

 private:
  using Decision = SearchState::Decision;
  struct Frame {
    std::vector<Decision> next;
    std::size_t tried;
    Folding::Mark mark;
    std::size_t decided;
  };

  SearchState::Branch branch_of(const Frame& frame) const;
  void push(std::vector<Decision> next);
  bool decide(const Decision& decision);
  void expand();
  bool hangs_on_settled(VisitId visit) const;
  void shuffle(std::vector<Decision>& next);
  bool settle_what_differs();
  Extents least_extents();
  Extents least_if_settled(Extents least, VisitId visit) const;

  const ArmTable& table_;
  const Preference& preference_;
  Folding folding_;
  SearchLevel& level_;
  IdVector<VisitId, std::uint32_t> ends_;  ///< of a visit's star: arms without gateway
  std::vector<Frame> frames_;
  std::vector<Decision> decided_;
  std::vector<VisitId> unsettled_;
  std::vector<std::uint64_t> flexible_;  ///< arms travelled by, of unsettled places
  std::uint32_t twice_paths_ = 0;        ///< at least, as found last
  std::uint64_t branchings_ = 0;
  std::optional<RandomEngine> wandering_;
  bool wanders_from_settled_ = false;
};

/// Where a search begins: many places no two of which can be one, all of them settled.
/// @pre  the trace has a visit
SearchState::Branch first_branch(const ArmTable& table, const Folding& folding);

}  // namespace asterism
