#pragma once

#include <filesystem>

namespace asterism {

/// The folder for the results of a run: of one run, and whole. They are written to a folder inside
/// it first, and moved where they belong once all are there; what an earlier run left goes then.
class ResultFolder {
 public:
  /// @throws Error if it cannot be made
  explicit ResultFolder(std::filesystem::path folder);
  /// Leaves the folder as it was, if it was not finished.
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;

  /// Where to write.
  const std::filesystem::path& unfinished() const { return unfinished_; }
  /// @throws std::filesystem::filesystem_error if a result cannot be moved
  void finish();

 private:
  std::filesystem::path folder_;
  std::filesystem::path unfinished_;
  bool is_new_;
};

}  // namespace asterism
