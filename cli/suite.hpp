#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cli/options.hpp"
#include "core/trace.hpp"
#include "io/expect_file.hpp"

namespace asterism {

// What `asterism test` is made of.

/// Reads an expect file, its queries too.
/// @throws InputError  that points into the file
Expectation read_expected_answers(const std::string& file);

/// What to ask of a trace of which nothing is said: all maps, and the planar ones.
Expectation default_questions();

/// "2 cases and 3 queries"
std::string size_text(const Expectation& expectation);

/// Asks traces what is expected of them, until its time is up.
class SuiteRun {
 public:
  explicit SuiteRun(const TestCommand& command) : command_(command) {}

  /// What a trace gives where an expectation was asked for; nothing where a limit or an interrupt
  /// left something undecided, which stopped_by() then says.
  /// @param file  of the expectation, for messages
  /// @throws InputError if it names visits or axioms that are not there
  std::optional<Expectation> found(const Trace& trace, Expectation asked, const std::string& file);
  const std::string& stopped_by() const { return stopped_by_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool answer(const Trace& trace, Expectation::Case& asked, const std::string& where);

  const TestCommand& command_;
  Clock::time_point begin_ = Clock::now();
  std::string stopped_by_;
};

}  // namespace asterism
