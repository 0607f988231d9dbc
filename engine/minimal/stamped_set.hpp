#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/id_vector.hpp"

namespace asterism {

/// A set of ids that is emptied at once: for passes over the same things, again and again. A member
/// bears the stamp of the pass.
template <class Id>
class StampedSet {
 public:
  /// @param ids  how many there are
  explicit StampedSet(std::size_t ids) : stamps_(ids, 0) {}

  void clear() {
    if (++stamp_ != 0) return;
    std::ranges::fill(stamps_, 0);
    stamp_ = 1;
  }
  bool contains(Id id) const { return stamps_[id] == stamp_; }
  /// @return whether it was not yet a member
  bool insert(Id id) {
    const bool is_new = !contains(id);
    stamps_[id] = stamp_;
    return is_new;
  }

 private:
  IdVector<Id, std::uint32_t> stamps_;
  std::uint32_t stamp_ = 1;
};

}  // namespace asterism
