#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axioms/theory.hpp"
#include "cli/asked_maps.hpp"
#include "core/experience.hpp"
#include "core/trace.hpp"

namespace asterism {

/// `asterism map`: what maps are asked for, and where they go.
struct MapCommand {
  AskedMaps maps;
  std::optional<std::string> svg_folder;
  std::optional<std::string> smt2_folder;
  std::vector<std::size_t> why_not;       ///< place of each visit, up to the one in question
  std::optional<std::string> checkpoint;  ///< file that the search can go on from
  double checkpoint_every_s = 10;
  bool resume = false;  ///< go on from there
};

/// Reads the theory asked for; records in the options which it is and, where the minimal models
/// alone are asked for, how they are found.
/// @throws InputError if it cannot be read, or needs the solver and `check` names another
Theory read_theory(MapCommand& command, std::vector<Assumption> assumptions = {});

/// @throws InputError if a command that lists maps is to write a checkpoint, which searches do
void require_no_checkpoint(const MapCommand& command, const std::string& found,
                           const std::string& expected);

// Each has the trace's maps found and told as the command asks, and returns the exit code.

/// Searches for the minimal models, without a list of all maps.
/// @pre  the axioms are the shipped ones, and the native engine decides
int map_minimal(const MapCommand& command, const Theory& theory, const Trace& trace);

/// Lists the maps of a trace of visits.
int map_trace(const MapCommand& command, const Theory& theory, const Trace& trace);

/// Lists the maps of an experience of the basic SSH.
int map_experience(MapCommand& command, const Experience& experience);

/// Tells, for every arm by which the last visit could have come in, why it could not.
int why_not(const MapCommand& command, const Theory& theory, const Trace& trace);

}  // namespace asterism
