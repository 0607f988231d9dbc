#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "core/trace.hpp"
#include "engine/minimal_search.hpp"
#include "io/checkpoint_file.hpp"

namespace asterism {

/// Keeps the file that a search can go on from.
class Checkpointing {
 public:
  /// @pre    the command names a file
  /// @throws InputError if the file is there and is not to be gone on from: it is another's
  Checkpointing(const MapCommand& command, const AxiomSet& axioms, const Trace& trace);

  /// Has a search go on from the file. Says so on stderr if there is none.
  /// @throws InputError if it is of another search, cannot be one of this, or is too large for the
  ///         memory limit
  void resume(MinimalSearch& search, const Progress& progress);
  /// Searches as MinimalSearch::run does, and writes the file at once, now and then, and where the
  /// search is stopped. What it cannot write later than at once, it says on stderr, and goes on.
  /// @throws InputError  if what was resumed cannot be a state of this search
  MinimalSearch::Outcome run(MinimalSearch& search,
                             const std::function<bool(const MinimalSearch&)>& go_on);
  /// Its result is written: the file is of no use any more.
  void remove() const;

 private:
  void write(const MinimalSearch& search);
  void try_to_write(const MinimalSearch& search);

  std::string file_;
  std::chrono::duration<double> every_;
  Checkpoint::Search search_;
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
  bool is_resumed_ = false;
};

}  // namespace asterism
