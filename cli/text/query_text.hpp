#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/assumption.hpp"
#include "core/topological_map.hpp"
#include "io/json/answers_json.hpp"

namespace asterism {

// What answers to all kinds of queries, and explanations, are made of.

/// "planar map", or "planar maps" if it is not one.
std::string noun(const AnswersReport& report, std::uint64_t count);

/// As it may be shown in one line: what is read has no control characters but white space.
std::string one_line(std::string query);

/// "0 1 2 0": the place of each visit.
std::string visits_text(const std::vector<Arrival>& arrivals);

/// "assuming same(3, 9)" and the end of the line; nothing where nothing is assumed.
std::string assuming_text(std::span<const Assumption> assumptions);

}  // namespace asterism
