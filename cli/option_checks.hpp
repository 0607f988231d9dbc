#pragma once

#include <string>

namespace CLI {
class Validator;
}

namespace asterism {

// What the values of options must be.

extern const CLI::Validator whole_number;
extern const CLI::Validator seconds;
/// Seconds, maybe with an s after the number, which is dropped.
extern const CLI::Validator duration;
/// Bytes, maybe with K, M or G after the number, of 1024 each; replaced by the number of bytes.
extern const CLI::Validator memory_size;

/// @param expected  what an error says
CLI::Validator number_between(double low, double high, const std::string& expected);

}  // namespace asterism
