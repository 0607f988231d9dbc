#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace asterism {

/// A vector of what is known of each of one kind of id, and indexed by no other.
template <class Id, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t size, const T& value = T()) : values_(size, value) {}

  decltype(auto) operator[](Id id) { return values_[id.index()]; }
  decltype(auto) operator[](Id id) const { return values_[id.index()]; }
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }

  void assign(std::size_t size, const T& value) { values_.assign(size, value); }
  void resize(std::size_t size, const T& value = T()) { values_.resize(size, value); }
  /// Drops what comes after the first so many.
  void keep_first(std::size_t size) {
    values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(size), values_.end());
  }
  void push_back(T value) { values_.push_back(std::move(value)); }

  auto begin() { return values_.begin(); }
  auto begin() const { return values_.begin(); }
  auto end() { return values_.end(); }
  auto end() const { return values_.end(); }

 private:
  std::vector<T> values_;
};

}  // namespace asterism
