#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>

#include "core/ssh_report.hpp"
#include "io/maps_file.hpp"

namespace asterism {

/// Calls its argument with one map after another.
using SshMapSource = std::function<void(const std::function<void(const SshMap&)>&)>;

/// Writes a maps file of the basic SSH, "kind": "ssh", with these maps instead of the report's.
/// @throws std::invalid_argument if a string is not UTF-8
void write_maps(std::ostream& out, const SshReport& report, const SshMapSource& maps);
void write_maps(std::ostream& out, const SshReport& report);

/// A maps file of either kind.
using AnyReport = std::variant<MapReport, SshReport>;

/// Reads a maps file of either kind. Of one of the basic SSH, checks that it agrees with itself:
/// places, paths and segments of every map follow from its dstates and the experience, the maps
/// are sorted, their number, paths and places are those told. Asks no axiom.
/// @throws InputError as read_maps
AnyReport read_any_maps(std::string_view json_text, const std::string& file_name);

/// @throws InputError as above, and if the file cannot be read or exceeds max_maps_bytes
AnyReport read_any_maps_file(const std::string& file);

}  // namespace asterism
