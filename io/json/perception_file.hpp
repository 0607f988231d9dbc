#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/perception_record.hpp"

namespace asterism {

/// Of a file that is read.
inline constexpr std::size_t max_perception_bytes = std::size_t{256} << 20;

/// Reads what is kept of a log's perception.
/// @param file  for messages
/// @throws InputError "file:/json/pointer: found ...; expected ..."
PerceptionRecord read_perception(std::string_view json_text, const std::string& file);
/// Reads it from the disk.
/// @throws InputError as read_perception, and if the file cannot be read or exceeds
///         max_perception_bytes
PerceptionRecord read_perception_file(const std::string& file);

/// What is kept, as a file's content, a pose to a line. Reads back as the same.
/// @throws std::invalid_argument if a pose is out of all bounds or a string is not UTF-8
std::string perception_json(const PerceptionRecord& record);
/// Writes it to the disk, whole or not at all.
/// @throws std::invalid_argument as perception_json, Error if the file cannot be written
void write_perception_file(const std::string& file, const PerceptionRecord& record);

}  // namespace asterism
