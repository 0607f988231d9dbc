#pragma once

#include <stdexcept>
#include <string>

namespace asterism {

/// What a caller may want to show a person. One line: *where: found ...; expected ...*.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Unreadable or invalid input: in which file, and where in it (JSON pointer or line).
class InputError : public Error {
 public:
  using Error::Error;
  /// @param where     file and place in it
  /// @param found     what is there, as it reads after "found"
  /// @param expected  what should be there instead
  InputError(const std::string& where, const std::string& found, const std::string& expected)
      : Error(where + ": found " + found + "; expected " + expected) {}
};

/// The solver failed. Not for its answer "unknown", which is Verdict::undecided.
class SolverError : public Error {
 public:
  using Error::Error;
};

/// The solver has not the memory it needs.
class SolverMemoryError : public SolverError {
 public:
  using SolverError::SolverError;
};

/// A plug-in cannot go on: which one, at what stamp or scan, and why.
class PluginError : public Error {
 public:
  using Error::Error;
};

}  // namespace asterism
