#pragma once

#include <string>

namespace CLI {
class Validator;
}

namespace asterism {

// What the values of options must be.

extern const CLI::Validator whole_number;
extern const CLI::Validator seconds;

/// @param expected  what an error says
CLI::Validator number_between(double low, double high, const std::string& expected);

}  // namespace asterism
