#include "benchmarks/heap.hpp"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace asterism {
namespace {

std::atomic<std::size_t> in_use = 0;  // Z3 keeps a thread for its clock
std::atomic<std::size_t> peak = 0;

void* take(std::size_t bytes) noexcept {
  void* const block = std::malloc(std::max<std::size_t>(bytes, 1));
  if (block == nullptr) return nullptr;
  in_use += malloc_usable_size(block);
  peak = std::max(peak.load(), in_use.load());
  return block;
}

void give_back(void* block) {
  if (block != nullptr) in_use -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

std::size_t heap_bytes() { return in_use; }
std::size_t heap_peak_bytes() { return peak; }
void reset_heap_peak() { peak = in_use.load(); }

}  // namespace asterism

// The other forms of new and delete, but for aligned ones, call these.
void* operator new(std::size_t bytes) {
  if (void* const block = asterism::take(bytes)) return block;
  throw std::bad_alloc();
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return asterism::take(bytes);
}
void operator delete(void* block) noexcept { asterism::give_back(block); }
void operator delete(void* block, std::size_t) noexcept { asterism::give_back(block); }
