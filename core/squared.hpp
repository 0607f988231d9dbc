#pragma once

namespace asterism {

/// x², in the square of its unit.
constexpr double squared(double x) { return x * x; }

}  // namespace asterism
