#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/topological_map.hpp"

namespace asterism {

/// What there may be fewer of in a simpler map.                                   [theory §6]
enum class Extent { path, place, segment };

/// Each extent once.
inline constexpr std::array all_extents{Extent::path, Extent::place, Extent::segment};

/// "path", "place", "segment": as files and users call it.
constexpr std::string_view name_of(Extent extent) {
  constexpr std::array<std::string_view, all_extents.size()> names{"path", "place", "segment"};
  return names[static_cast<std::size_t>(extent)];
}

/// The extent of that name, if there is one.
constexpr std::optional<Extent> extent_named(std::string_view name) {
  for (const Extent extent : all_extents)
    if (name_of(extent) == name) return extent;
  return std::nullopt;
}

/// How many of each there are in a map.
struct Extents {
  std::uint32_t paths = 0;
  std::uint32_t places = 0;
  std::uint32_t segments = 0;

  /// The number of one of them.
  constexpr std::uint32_t of(Extent extent) const {
    return extent == Extent::path ? paths : extent == Extent::place ? places : segments;
  }
  friend bool operator==(const Extents&, const Extents&) = default;
};

/// The extents of a map written out.
inline Extents extents_of(const TopologicalMap& map) {
  const auto size = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  return {.paths = size(map.paths), .places = size(map.places), .segments = size(map.segments)};
}

}  // namespace asterism
