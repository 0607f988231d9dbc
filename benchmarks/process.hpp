#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asterism {

struct ProcessResult {
  std::string output;  ///< standard output
  double wall_s = 0;
  double cpu_s = 0;              ///< of all its threads, user and system
  std::optional<int> exit_code;  ///< absent: it was still running at the time limit, or died
};

/// Runs a program of the search path, without input, and waits for its end.
/// @throws std::system_error if it cannot be started
ProcessResult run_process(const std::vector<std::string>& command, double time_limit_s);

/// A folder for files of this process, removed in the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(std::string_view name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

}  // namespace asterism
