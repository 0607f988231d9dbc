#include "tests/engine/command_line.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace asterism {

bool is_installed(const std::string& program) {
  return std::system((program + " --version > /dev/null 2>&1").c_str()) == 0;
}

std::string output_of(const std::string& command, const std::string& content) {
  const auto file =
      std::filesystem::temp_directory_path() / ("asterism-input-" + std::to_string(getpid()));
  std::ofstream(file) << content;
  FILE* pipe = popen((command + " " + file.string() + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(command + ": found no process; expected one");
  std::string output;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output += static_cast<char>(c);
  pclose(pipe);
  std::filesystem::remove(file);
  return output;
}

}  // namespace asterism
