#pragma once

namespace asterism {

/// Exit codes, beside those of sysexits.h.                                           [STYLE §5]
enum ExitCode {
  exit_consistent = 0,
  exit_inconsistent = 1,
  exit_undecided = 2,
  exit_usage = 64,
  exit_bad_input = 65,
  exit_plugin = 69,
  exit_internal = 70
};

}  // namespace asterism
