#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/arm_table.hpp"

namespace asterism {

/// A tree all of whose leaves are on one level, as one flat list: a node, then its subtree, then
/// its next sibling.  Level k names the arm by which visit k was entered.
class Preorder {
 public:
  struct Node {
    std::uint32_t arm : 31;
    std::uint32_t has_next_sibling : 1;
  };

  std::span<const Node> nodes() const { return std::span(nodes_).first(size_); }
  /// Gives up the room kept for growth.
  void shrink() {
    nodes_.resize(size_);
    nodes_.shrink_to_fit();
  }
  std::size_t memory_bytes() const { return nodes_.capacity() * sizeof(Node); }

  /// Calls f(leaf number, arms from the root down) for every leaf, in order, until it returns
  /// false.
  template <class F>
  void for_each_leaf(std::size_t levels, F&& f) const {
    std::vector<ArmIndex> named;
    std::vector<bool> has_next_sibling;
    std::uint64_t leaf = 0;
    for (const Node node : nodes()) {
      named.push_back(node.arm);
      has_next_sibling.push_back(node.has_next_sibling);
      if (named.size() < levels) continue;
      if (!f(leaf++, std::span<const ArmIndex>(named))) return;
      while (!named.empty() && !has_next_sibling.back()) {
        named.pop_back();
        has_next_sibling.pop_back();
      }
      if (named.empty()) return;
      named.pop_back();
      has_next_sibling.pop_back();
    }
  }

  /// The children of one node while they are being written: each either stays, with all that was
  /// written below it, or is taken back.
  class Siblings {
   public:
    /// @param levels  below which no descendant will be
    Siblings(Preorder& tree, std::size_t levels) : tree_(tree), levels_(levels) {}

    void begin(ArmIndex arm) {
      begun_ = tree_.size_;
      if (tree_.nodes_.size() < begun_ + levels_) tree_.make_room(levels_);
      tree_.push(arm);
    }
    /// Below the one begun, a descendant in a line of only children.
    void add_below(ArmIndex arm) { tree_.push(arm); }
    void keep() {
      if (any_) tree_.nodes_[last_].has_next_sibling = 1;
      last_ = begun_;
      any_ = true;
    }
    void take_back() { tree_.size_ = begun_; }
    bool any() const { return any_; }

   private:
    Preorder& tree_;
    std::size_t levels_;
    std::size_t begun_ = 0;
    std::size_t last_ = 0;
    bool any_ = false;
  };

 private:
  void push(ArmIndex arm) { nodes_[size_++] = {arm & 0x7fffffffU, 0}; }
  [[gnu::noinline]] void make_room(std::size_t nodes) {
    nodes_.resize(std::max(std::size_t{256}, 2 * (size_ + nodes)));
  }

  std::vector<Node> nodes_;
  std::size_t size_ = 0;  ///< of nodes_ in use
};

}  // namespace asterism
