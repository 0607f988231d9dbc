#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axioms/independence.hpp"
#include "core/trace.hpp"

namespace asterism {

/// What `asterism verify` found out of one axiom.
struct AxiomFinding {
  Axiom axiom;
  bool is_optional = false;  ///< not in force: put to those that are
  Independence independence;
};

/// Native engine and solver, and what maps count, on traces.
struct EnginesFinding {
  bool is_native = true;   ///< the native engine knows the axioms, and was compared
  std::size_t traces = 0;  ///< each taken twice: all maps, and planar ones
  std::uint64_t candidates = 0;
  std::uint64_t hypotheses = 0;           ///< that explain the whole traces
  std::size_t maps_counted = 0;           ///< against the least closure
  std::size_t cut_short = 0;              ///< of twice as many, those with too many maps
  std::size_t certified = 0;              ///< those whose minimal models the solver certified
  std::size_t not_certified = 0;          ///< those of which it did not in time
  std::optional<std::string> difference;  ///< of native and solver, or of a count
  std::optional<Trace> shortest;          ///< a trace that shows the difference
  std::optional<std::string> remark;      ///< on counts of axioms that are not the shipped ones
  std::optional<std::string> stopped_by;
};

/// What changes with other axioms than the shipped.
struct ChangeFinding {
  std::vector<std::string> added;
  std::vector<std::string> removed;
  std::vector<std::string> changed;
  std::vector<std::string> preference;  ///< where it is another one
  std::vector<std::string> shipped_preference;

  std::size_t traces = 0;
  std::size_t traces_that_differ = 0;
  std::size_t cut_short = 0;  ///< traces compared until there were too many maps
  std::uint64_t shipped = 0;  ///< hypotheses, as far as traces were compared
  std::uint64_t ours = 0;
  std::uint64_t gained = 0;            ///< of ours, those the shipped axioms refute
  std::uint64_t lost = 0;              ///< of the shipped ones', those ours refute
  std::optional<Trace> smallest;       ///< the trace of fewest visits that shows a difference
  std::uint64_t smallest_shipped = 0;  ///< hypotheses of it
  std::uint64_t smallest_ours = 0;
  std::optional<std::string> stopped_by;
};

/// What `asterism verify` found out: the content of a file of a verification.   [docs/formats.md]
struct VerifyReport {
  std::string axioms;  ///< where they are from
  std::vector<std::string> optional_axioms;
  std::vector<AxiomFinding> findings;
  Independence together;  ///< of "no travel leads from one place to another", from all of them
  std::size_t worlds = 0;
  std::uint64_t seed = 0;
  std::vector<std::string> files;  ///< traces beside those of random worlds
  std::optional<EnginesFinding> engines;
  std::optional<ChangeFinding> change;
};

/// The file's content, an axiom a line.
/// @param faults     what is not as it should be, in words
/// @param undecided  what was not found out
std::string verification_json(const VerifyReport& report, std::span<const std::string> faults,
                              std::span<const std::string> undecided);

}  // namespace asterism
