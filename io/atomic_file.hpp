#pragma once

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

/// The same, the content being what `write` puts into the stream. What `write` throws passes on.
void write_atomically(const std::string& file, const std::function<void(std::ostream&)>& write);

}  // namespace asterism
