#pragma once

namespace asterism {

/// An answer, never an error. Undecided (time, memory) refutes nothing.       [theory §8]
enum class Verdict { consistent, inconsistent, undecided };

}  // namespace asterism
