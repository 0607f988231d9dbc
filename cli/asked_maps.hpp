#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/map_report.hpp"
#include "engine/ask/query_reader.hpp"
#include "mapping/axiom_source.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace asterism {

/// What maps of what trace a command asks, as read from the command line.
struct AskedMaps {
  std::string trace;  ///< file, or "-"
  AxiomSource axioms = {};
  MapOptions options = {};
  std::vector<std::string> assume = {};  ///< texts of assumptions
  bool only_minimal = false;             ///< the minimal models are asked, not all maps
  unsigned jobs = 1;                     ///< threads of the search for them
  std::optional<std::string> json = {};  ///< file for the answer, or "-"
};

void add_axiom_options(CLI::App& app, AxiomSource& source);
/// The trace, and which maps of it there are.
void add_maps_of_trace(CLI::App& app, AskedMaps& asked);
/// Who decides; to be given beside add_maps_of_trace.
void add_check(CLI::App& app, MapOptions& options);
/// What is known beside the trace.
void add_assumptions(CLI::App& app, std::vector<std::string>& texts);
/// Threads of the search for minimal models.
CLI::Option& add_jobs(CLI::App& app, unsigned& jobs);
/// Whether all maps are asked, or the minimal models alone.
/// @param what  the text of the help
void add_over(CLI::App& app, AskedMaps& asked, const std::string& what);
/// When to stop.
void add_limits(CLI::App& app, MapOptions& options);

/// A trace file, stdin for "-".
std::string file_of(const AskedMaps& asked);
/// What is assumed, as read from texts.
/// @throws QueryError
std::vector<StatedAssumption> read_assumptions(std::span<const std::string> texts);
/// Reads the theory asked for, and records in the options which it is.
/// @throws InputError if it cannot be read
Theory read_theory(AskedMaps& asked, std::vector<Assumption> assumptions = {});
/// What to say where the shipped axioms and extents are expected.
std::string other_than_shipped(const AxiomSet& axioms);
/// @throws InputError if the axioms or their extents need the solver, and `check` does not name it
void require_decidable(const Theory& theory, const MapOptions& options);

/// Where the answer is written: alone on stdout, or else to the file asked for, if there is one.
/// @return  whether it is to be told in words, too
bool write_answer(const AskedMaps& asked, const std::string& json);

}  // namespace asterism
