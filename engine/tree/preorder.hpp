#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <vector>

namespace asterism {

/// A tree all of whose leaves are on one level, as one flat list: a node, then its subtree, then
/// its next sibling.  A node names what was chosen at its level: the arm by which visit k was
/// entered.
/// @tparam Choice  an id below 2³¹
template <class Choice>
class Preorder {
 public:
  class Node {
   public:
    Node(Choice choice, bool has_next_sibling)
        : choice_(static_cast<std::uint32_t>(choice.index()) & 0x7fffffffU),
          has_next_sibling_(has_next_sibling) {}
    Choice choice() const { return Choice(choice_); }
    bool has_next_sibling() const { return has_next_sibling_; }
    void set_has_next_sibling(bool has) { has_next_sibling_ = has; }

   private:
    std::uint32_t choice_ : 31;
    std::uint32_t has_next_sibling_ : 1;
  };

  std::span<const Node> nodes() const { return {nodes_.get(), size_}; }
  /// Gives up the room kept for growth.
  void shrink() { set_room(std::max(size_, std::size_t{1})); }
  std::size_t memory_bytes() const { return room_ * sizeof(Node); }

  /// Calls f(leaf number, choices from the root down) for every leaf, in order, until it returns
  /// false.
  template <class F>
  void for_each_leaf(std::size_t levels, F&& f) const {
    std::vector<Choice> named;
    std::vector<bool> has_next_sibling;
    std::uint64_t leaf = 0;
    for (const Node node : nodes()) {
      named.push_back(node.choice());
      has_next_sibling.push_back(node.has_next_sibling());
      if (named.size() < levels) continue;
      if (!f(leaf++, std::span<const Choice>(named))) return;
      while (!named.empty() && !has_next_sibling.back()) {
        named.pop_back();
        has_next_sibling.pop_back();
      }
      if (named.empty()) return;
      named.pop_back();
      has_next_sibling.pop_back();
    }
  }

  /// Leaves that are siblings, one after another; end_leaves() after the last.
  void add_leaf(Choice choice) {
    if (room_ == size_) make_room(1);
    nodes_[size_++] = Node(choice, true);
  }
  void end_leaves() { nodes_[size_ - 1].set_has_next_sibling(false); }

  /// The children of one node while they are being written: each either stays, with all that was
  /// written below it, or is taken back.
  class Siblings {
   public:
    /// @param levels  below which no descendant will be
    Siblings(Preorder& tree, std::size_t levels) : tree_(tree), levels_(levels) {}

    [[gnu::always_inline]] void begin(Choice choice) {
      begun_ = tree_.size_;
      if (tree_.room_ < begun_ + levels_) tree_.make_room(levels_);
      tree_.push(choice);
    }
    /// Below the one begun, a descendant in a line of only children.
    void add_below(Choice choice) { tree_.push(choice); }
    void keep() {
      if (any_) tree_.nodes_[last_].set_has_next_sibling(true);
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
  void push(Choice choice) { nodes_[size_++] = Node(choice, false); }
  [[gnu::noinline]] void make_room(std::size_t nodes) {
    set_room(std::max(std::size_t{256}, 2 * (size_ + nodes)));
  }
  // A vector would fill room not used yet and copy what is there; half the time went into that.
  // realloc moves a large block by its pages.
  void set_room(std::size_t nodes) {
    void* const moved = std::realloc(nodes_.get(), nodes * sizeof(Node));
    if (moved == nullptr) throw std::bad_alloc();
    static_cast<void>(nodes_.release());
    nodes_.reset(static_cast<Node*>(moved));
    room_ = nodes;
  }

  struct Free {
    void operator()(Node* nodes) const { std::free(nodes); }
  };
  std::unique_ptr<Node[], Free> nodes_;
  std::size_t room_ = 0;
  std::size_t size_ = 0;  ///< of the room, in use
};

}  // namespace asterism
