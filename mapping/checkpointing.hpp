#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "core/stop.hpp"
#include "engine/minimal/minimal_search.hpp"
#include "io/json/checkpoint_file.hpp"

namespace asterism {

/// Keeps the file that a search can go on from.
class Checkpointing {
 public:
  struct Options {
    std::string file;
    std::chrono::duration<double> every = std::chrono::seconds(10);
    /// Told of a file that could not be written, while the search goes on.
    std::function<void(const std::string&)> failed = [](const std::string&) {};
  };

  /// @param search  what must be the same in a file to go on from
  Checkpointing(Options options, Checkpoint::Search search)
      : options_(std::move(options)), search_(std::move(search)) {}

  /// Has a search go on from the file.
  /// @return  false if there is no file
  /// @throws InputError if it is of another search, cannot be one of this, or is too large for the
  ///         memory limit
  bool resume(MinimalSearch& search, const Stop& stop);
  /// Searches as MinimalSearch::run does, and writes the file at once, now and then, and where the
  /// search is stopped. Only what it cannot write at once ends the search.
  /// @throws InputError  if what was resumed cannot be a state of this search
  /// @throws Error       if the file cannot be written at once
  MinimalSearch::Outcome run(MinimalSearch& search, const Stop& stop);
  /// Its result is written: the file is of no use any more.
  void remove() const;

 private:
  void write(const MinimalSearch& search);
  void try_to_write(const MinimalSearch& search);

  Options options_;
  Checkpoint::Search search_;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  bool is_resumed_ = false;
};

}  // namespace asterism
