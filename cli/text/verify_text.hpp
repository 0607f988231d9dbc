#pragma once

#include <string>
#include <vector>

#include "io/json/verification_json.hpp"

namespace asterism {

/// The report for people: a block an axiom, then what concerns them all, and last the result.
std::string verify_text(const VerifyReport& report);

/// What is not as it should be, in one line each; empty: all is well.
std::vector<std::string> faults_of(const VerifyReport& report);

/// What was not found out, in one line each; empty: nothing is left open.
std::vector<std::string> undecided_of(const VerifyReport& report);

}  // namespace asterism
