#pragma once

#include <filesystem>
#include <system_error>

namespace asterism {

/// Why files could not be moved.
struct MoveFault {
  std::error_code error;
  bool are_back = true;  ///< whether all lie again where they did
};

/// The folder for the results of a run: of one run, and whole. They are written to a folder beside
/// it, and the two change places in one step once all are there; what an earlier run left goes
/// then, and what else lay there stays. Where folders cannot change places (a mounted one, the
/// one that the program runs in), files are moved one by one, and back again if one cannot be.
class ResultFolder {
 public:
  /// @throws Error if it cannot be made, or an earlier run has kept files there that it could not
  ///         move
  explicit ResultFolder(const std::filesystem::path& folder);
  /// Leaves the folder as it was, if it was not finished.
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;

  /// Where to write.
  const std::filesystem::path& unfinished() const { return unfinished_; }
  /// @throws Error if the results cannot be moved: they then lie where they were written, until the
  ///         next run, and what an earlier run left lies where it did, or with them if it cannot be
  ///         moved back either; then the next run leaves both alone
  void finish();

 private:
  bool swap();
  void move_one_by_one();
  [[noreturn]] void refuse(const MoveFault& fault, bool are_back) const;

  std::filesystem::path folder_;
  std::filesystem::path unfinished_;
  bool is_new_;
  bool is_kept_ = false;  ///< `unfinished_`, where what is in it could not be moved
};

}  // namespace asterism
