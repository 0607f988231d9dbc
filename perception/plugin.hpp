#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "perception/place_detector.hpp"

namespace asterism {

/// What a shared library with a detector says of itself.                   [docs/detectors.md]
///
/// Visits, scans and the detector itself cross the boundary as C++ objects. So the library must be
/// built with the compiler and against the headers of the program that loads it; what is filled in
/// here by default tells whether it was. The library defines, at global scope,
///
///     const asterism::DetectorPlugin asterism_detector_plugin{.create = my_detector};
struct DetectorPlugin {
  /// Of this struct, as this program knows it.
  static constexpr std::uint32_t current_form = 1;
  /// Of the headers of this program.
  static constexpr const char* current_version = "0.2.0";
  /// By which this program is built.
  static constexpr const char* current_compiler = __VERSION__;
  /// Of a scan and a visit, in bytes.
  static constexpr std::array<std::size_t, 2> current_sizes{sizeof(Scan), sizeof(DetectedVisit)};

  std::uint32_t form = current_form;  ///< of this struct; always its first member
  const char* version = current_version;
  const char* compiler = current_compiler;
  std::array<std::size_t, 2> sizes = current_sizes;  ///< differ where compiler options do
  /// Makes a detector; whatever it throws becomes a PluginError.
  std::unique_ptr<PlaceDetector> (*create)() = nullptr;
};

}  // namespace asterism

extern "C" {
/// Defined by the library alone: what load_detector looks for.
[[gnu::visibility("default")]] extern const asterism::DetectorPlugin asterism_detector_plugin;
}
