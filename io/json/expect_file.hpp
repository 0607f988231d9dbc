#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/id.hpp"
#include "core/theory_record.hpp"

namespace asterism {

/// What a trace is expected to give: the content of an expect file.
struct Expectation {
  struct Minimal {
    std::size_t paths = 0;
    std::size_t places = 0;
    std::uint64_t count = 0;
    /// Place of each visit in each of the first max_expected_models models, sorted. Equal ones
    /// differ in how places were entered.
    std::vector<std::vector<PlaceId>> visits = {};

    friend bool operator==(const Minimal&, const Minimal&) = default;
  };
  struct Counts {
    std::vector<std::uint64_t> per_visit;  ///< maps after visit k; the last explain the trace
    std::optional<Minimal> minimal = {};   ///< absent: no map explains the trace

    friend bool operator==(const Counts&, const Counts&) = default;
  };
  struct Answer {
    std::uint64_t holds = 0;  ///< in as many maps
    std::uint64_t of = 0;

    friend bool operator==(const Answer&, const Answer&) = default;
  };
  struct Question {
    std::string query;          ///< text, as docs/queries.md has it
    bool only_minimal = false;  ///< asked of the minimal models
    std::optional<Answer> answer = {};

    friend bool operator==(const Question&, const Question&) = default;
  };
  /// What is asked, and where it was recorded, what came out.
  struct Case {
    TheoryRecord theory = {};  ///< of shipped axioms and the shipped preference
    std::optional<Counts> counts = {};
    std::vector<Question> queries = {};

    friend bool operator==(const Case&, const Case&) = default;
  };
  std::vector<Case> cases;  ///< one at least, all of other options

  friend bool operator==(const Expectation&, const Expectation&) = default;
};

inline constexpr std::size_t max_expect_bytes = std::size_t{64} << 20;  ///< of a file that is read
inline constexpr std::size_t max_expected_models = 100;                 ///< spelt out in a file

/// Reads an expect file, and checks that it agrees with itself. Does not read the queries.
/// @param file_name  for messages
/// @throws InputError "file:/json/pointer: found ...; expected ..."; for what is not JSON
///         "file:line:column: ..."
Expectation read_expectation(std::string_view json_text, const std::string& file_name);

/// Reads an expect file.
/// @throws InputError as read_expectation, and if the file cannot be read or exceeds
/// max_expect_bytes
Expectation read_expect_file(const std::string& file);

/// The content of an expect file, which reads back as the same.
/// @throws std::invalid_argument if a string is not UTF-8
std::string expectation_json(const Expectation& expectation);

/// "certain", "possible" or "impossible".
const char* verdict_of(const Expectation::Answer& answer);

}  // namespace asterism
