#pragma once

#include "core/trace.hpp"
#include "io/json/answers_json.hpp"

namespace asterism {

/// Prints the routes asked for and what was found, in words, on stdout.
void print_routes(const AnswersReport& report, const Trace& trace);

}  // namespace asterism
