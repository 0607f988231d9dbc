#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "axioms/axiom_set.hpp"
#include "cli/map_text.hpp"
#include "cli/options.hpp"
#include "core/error.hpp"
#include "io/maps_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

/// Reads a file of whatever kind its name says; tells what it is.
std::string validated(const std::string& file) {
  if (file.ends_with("maps.json")) {
    const MapReport report = read_maps_file(file);
    return fmt::format("maps of {}: {} listed", printable(report.trace), report.maps.size());
  }
  if (std::filesystem::is_directory(file)) {
    const AxiomSet axioms = AxiomSet::read(file);
    return fmt::format("a folder of {} axioms", axioms.axioms().size());
  }
  const Trace trace = read_trace_file(file);
  return fmt::format("trace {}: {} visits", printable(trace.name), trace.visits.size());
}

}  // namespace

int validate_command(const std::vector<std::string>& files) {
  int result = exit_consistent;
  for (const std::string& file : files) {
    try {
      fmt::print("{}: valid, {}\n", file, validated(file));
    } catch (const InputError& error) {
      fmt::print(stderr, "{}\n", error.what());
      result = exit_bad_input;
    }
  }
  return result;
}

}  // namespace asterism
