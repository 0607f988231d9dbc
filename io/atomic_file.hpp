#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace asterism {

/// Writes a file whole or not at all: into a new file in the same folder, which is brought to the
/// disk and then renamed. What is there already and no plain file (a device, a pipe, a symbolic
/// link) is written in place instead.
///
/// @throws Error "file: found ...; expected to write it"; then the file is as it was before
void write_atomically(const std::string& file, std::string_view content);

/// Writes what `write` puts into the stream to a file, whole or not at all. What `write` throws
/// passes on.
void write_atomically(const std::string& file, const std::function<void(std::ostream&)>& write);

/// Makes a folder, and those it lies in, where it is not there yet.
/// @throws Error if it cannot be made
void make_folder(const std::filesystem::path& folder);

/// Removes what an earlier run left of a numbered row of files, from this number up.
/// @param pattern  the files' name, {} for the number
void remove_from(const std::filesystem::path& folder, const std::string& pattern,
                 std::size_t number);

}  // namespace asterism
