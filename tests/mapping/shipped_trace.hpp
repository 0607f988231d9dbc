#pragma once

#include <string>

#include "core/trace.hpp"
#include "io/json/trace_file.hpp"

namespace asterism {

/// A trace that stands beside the examples: "aces-stubs", of which there are 107 maps, 55 of them
/// planar; "04_ring", of 6.
inline Trace shipped_trace(const std::string& name) {
  return read_trace_file(ASTERISM_SOURCE_DIR "/examples/" + name + ".trace.json");
}

}  // namespace asterism
