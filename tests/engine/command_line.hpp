#pragma once

#include <string>

namespace asterism {

bool is_installed(const std::string& program);

/// What a command prints, errors too, given the name of a file with this content as its last
/// argument.  @throws std::runtime_error if no process starts
std::string output_of(const std::string& command, const std::string& content);

}  // namespace asterism
