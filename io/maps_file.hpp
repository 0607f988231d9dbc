#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

#include "core/map_report.hpp"

namespace asterism {

inline constexpr std::size_t max_maps_bytes = std::size_t{256} << 20;

/// Calls its argument with one map after another.
using MapSource = std::function<void(const std::function<void(const TopologicalMap&)>&)>;

/// Writes a maps file, map by map, one line a part of a map.                       [DESIGN §9]
/// @throws std::invalid_argument if a string is not UTF-8 or a number is not finite
void write_maps(std::ostream& out, const MapReport& report);
/// The same with these maps instead of the report's: there may be too many to hold.
void write_maps(std::ostream& out, const MapReport& report, const MapSource& maps);

/// Whole or not at all.
/// @throws std::invalid_argument as above, Error if the file cannot be written
void write_maps_file(const std::string& file, const MapReport& report);

/// Reads a maps file as write_maps writes it, and checks that it agrees with itself: every map
/// follows from its visits and stars (io/map_json.hpp), the maps are of one trace and sorted, their
/// number, paths and places are those told. Asks no axiom.
///
/// @throws InputError "file:/json/pointer: found ...; expected ..."; for what is not JSON
///         "file:line:column: ..."
MapReport read_maps(std::string_view json_text, const std::string& file_name);

/// @throws InputError as above, and if the file cannot be read or exceeds max_maps_bytes
MapReport read_maps_file(const std::string& file);

}  // namespace asterism
