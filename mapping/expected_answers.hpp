#pragma once

#include <optional>
#include <string>

#include "core/trace.hpp"
#include "io/json/expect_file.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {

/// Reads an expect file, its queries too.
/// @throws InputError  that points into the file
Expectation read_expected_answers(const std::string& file);

/// What to ask of a trace of which nothing is said: all maps, and the planar ones.
Expectation default_questions();

/// "2 cases and 3 queries"
std::string size_text(const Expectation& expectation);

/// What a trace gives where an expectation was asked for.
struct FoundAnswers {
  std::optional<Expectation> answers;  ///< nothing: something was left undecided
  std::string stopped_by = {};         ///< by this limit or interrupt, then
};

/// Asks a trace what is expected of it.
/// @param options  who decides, and how many maps there may be; what else they say is not asked
/// @param file     of the expectation, for messages
/// @throws InputError if it names visits or axioms that are not there
FoundAnswers find_answers(const Trace& trace, Expectation asked, const MapOptions& options,
                          const std::string& file, const MapWatch& watch = {});

}  // namespace asterism
