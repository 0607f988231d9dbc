#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/map_report.hpp"

namespace asterism {

/// Of a file that is read.
inline constexpr std::size_t max_maps_bytes = std::size_t{256} << 20;

/// Calls its argument with one map after another.
template <class Map>
using SourceOf = std::function<void(const std::function<void(const Map&)>&)>;
using MapSource = SourceOf<TopologicalMap>;
using SshMapSource = SourceOf<SshMap>;

/// These maps, which must outlive it.
template <class Map>
SourceOf<Map> each_of(const std::vector<Map>& maps) {
  return [&](const auto& write) {
    for (const Map& map : maps) write(map);
  };
}

/// Writes a maps file, map by map, with these maps instead of the report's: there may be too many
/// to hold.                                                                        [theory §9]
/// @throws std::invalid_argument if a string is not UTF-8 or a number is not finite
void write_maps(std::ostream& out, const MapReport& report, const MapSource& maps);

/// Writes a maps file of the basic SSH, "kind": "ssh", with these maps instead of the report's.
/// @throws std::invalid_argument if a string is not UTF-8 or a number is not finite
void write_maps(std::ostream& out, const SshReport& report, const SshMapSource& maps);

/// Writes a maps file of either kind with the report's maps.
/// @throws std::invalid_argument if a string is not UTF-8 or a number is not finite
template <class Report>
void write_maps(std::ostream& out, const Report& report) {
  write_maps(out, report, each_of(report.maps));
}

/// Writes a maps file to the disk, whole or not at all.
/// @throws std::invalid_argument as write_maps, Error if the file cannot be written
void write_maps_file(const std::string& file, const MapReport& report);

/// A maps file of either kind.
using AnyReport = std::variant<MapReport, SshReport>;

/// Reads a maps file as write_maps writes it, and checks that it agrees with itself: every map
/// follows from its visits and stars (io/map_json.hpp), or from its dstates and the experience, the
/// maps are of one trace and sorted, their number, paths and places are those told. Asks no axiom.
///
/// @throws InputError "file:/json/pointer: found ...; expected ..."; for what is not JSON
///         "file:line:column: ..."
AnyReport read_any_maps(std::string_view json_text, const std::string& file_name);

/// Reads a maps file of either kind from the disk.
/// @throws InputError as read_any_maps, and if the file cannot be read or exceeds max_maps_bytes
AnyReport read_any_maps_file(const std::string& file);

}  // namespace asterism
