#pragma once

#include <cstddef>

namespace asterism {

/// Bytes taken from the heap by what is linked into this program and not yet given back, in this
/// thread.
std::size_t heap_bytes();
/// The most these have been since reset_heap_peak().
std::size_t heap_peak_bytes();
void reset_heap_peak();

}  // namespace asterism
