#include "benchmarks/heap.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace asterism {
namespace {

// Of each thread its own: to share them would slow down what runs in several.
thread_local std::size_t in_use = 0;
thread_local std::size_t peak = 0;

void* taken(void* block) {
  if (block != nullptr) in_use += malloc_usable_size(block);
  peak = std::max(peak, in_use);
  return block;
}

void given_back(void* block) {
  if (block != nullptr) in_use -= malloc_usable_size(block);
}

}  // namespace

std::size_t heap_bytes() { return in_use; }
std::size_t heap_peak_bytes() { return peak; }
void reset_heap_peak() { peak = in_use; }

}  // namespace asterism

// The linker puts these in the place of malloc, realloc and free (--wrap).
extern "C" {
void* __real_malloc(std::size_t bytes);
void* __real_realloc(void* block, std::size_t bytes);
void __real_free(void* block);

void* __wrap_malloc(std::size_t bytes) { return asterism::taken(__real_malloc(bytes)); }
void* __wrap_realloc(void* block, std::size_t bytes) {
  asterism::given_back(block);
  return asterism::taken(__real_realloc(block, bytes));
}
void __wrap_free(void* block) {
  asterism::given_back(block);
  __real_free(block);
}
}

// The other forms of new and delete, but for aligned ones, call these.
void* operator new(std::size_t bytes) {
  if (void* const block = std::malloc(std::max<std::size_t>(bytes, 1))) return block;
  throw std::bad_alloc();
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return std::malloc(std::max<std::size_t>(bytes, 1));
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
