#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "core/trace.hpp"
#include "engine/map_tree.hpp"
#include "engine/query_reader.hpp"

namespace asterism {

// What `asterism map` is made of.

/// Reads the axioms that a command asks for, and records in its options which these are.
/// @throws InputError if they cannot be read, or need the solver and `check` names another
AxiomSet read_axioms(MapCommand& command);

/// @throws InputError if a command that lists maps is to write a checkpoint, which searches do
void require_no_checkpoint(const MapCommand& command, const std::string& found,
                           const std::string& expected);

/// What is assumed, as read; `require_visits` says which assumptions a trace cannot have.
/// @throws QueryError
std::vector<StatedAssumption> read_assumptions(std::span<const std::string> texts);
/// @throws InputError if they name visits that the trace does not have
std::vector<Assumption> assumptions_of(std::span<const StatedAssumption> stated,
                                       const Trace& trace);
/// "assuming same(3, 9)" and the end of the line; nothing where nothing is assumed.
std::string assuming_text(std::span<const Assumption> assumptions);

MapTree::Options tree_options(const MapCommand& command, const AxiomSet& axioms);

/// @throws Error if it cannot be made
void make_folder(const std::filesystem::path& folder);

/// Removes what an earlier run left of a numbered row of files, from this number up.
/// @param pattern  the files' name, {} for the number
void remove_from(const std::filesystem::path& folder, const std::string& pattern,
                 std::size_t number);

/// Writes the grounded problem of a hypothesis, as SMT-LIB 2.
void write_problem(const std::filesystem::path& folder, const std::string& name, const Trace& trace,
                   std::span<const Arrival> hypothesis, const AxiomSet& axioms);

/// Tells, for every arm by which the last visit could have come in, why it could not.
/// @return exit code
int why_not(const MapCommand& command, const AxiomSet& axioms, const Trace& trace);

}  // namespace asterism
