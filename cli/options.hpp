#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/map_report.hpp"
#include "engine/exits.hpp"
#include "io/carmen_log.hpp"
#include "perception/scan_detector.hpp"

namespace asterism {

/// What a subcommand was asked, as read from the command line.

struct AxiomOptions {
  std::optional<std::string> folder;  ///< absent: the shipped axioms
  std::vector<std::string> optional;  ///< names, switched on

  /// @throws InputError if they cannot be read
  AxiomSet read() const {
    return folder ? AxiomSet::read(*folder, optional) : AxiomSet::shipped(optional);
  }
};

struct MapCommand {
  std::string trace;
  MapOptions options;
  AxiomOptions axioms;
  std::size_t visits = 0;           ///< of the trace
  std::optional<std::string> json;  ///< file, or "-"
  std::vector<std::string> assume;  ///< texts of assumptions
  std::optional<std::string> svg_folder;
  std::optional<std::string> smt2_folder;
  std::vector<std::size_t> why_not;       ///< place of each visit, up to the one in question
  bool minimal = false;                   ///< search for the minimal models alone
  unsigned jobs = 1;                      ///< threads of the search
  std::optional<std::string> checkpoint;  ///< file that the search can go on from
  double checkpoint_every_s = 10;
  bool resume = false;  ///< go on from there
};

struct QueryCommand {
  MapCommand map;  ///< what maps to ask
  std::vector<std::string> queries;
  bool only_minimal = false;
  bool by_solver = false;  ///< instead of listing the maps
};

struct ExplainCommand {
  MapCommand map;  ///< what maps to ask
  std::string query;
  bool only_minimal = false;
  std::optional<std::string> svg;
};
inline constexpr double default_explain_s = 60;

struct VerifyCommand {
  AxiomOptions axioms;
  std::vector<std::string> traces;  ///< beside those of random worlds
  std::size_t worlds = 40;
  std::uint64_t seed = 0;
  std::optional<std::string> json;  ///< file, or "-"
  std::optional<double> time_limit_s;
};

struct NextCommand {
  MapCommand map;  ///< what maps to go on from
  ExitBounds bounds;
  bool only_minimal = false;
  std::optional<std::string> svg;
};

struct TestCommand {
  std::string folder;
  std::string check = "native";      ///< who decides
  MapOptions limits;                 ///< of these, when to stop
  std::optional<std::string> junit;  ///< file
  bool update = false;               ///< record what comes out
};

struct SimulateCommand {
  std::string world = "grid";           ///< or "corridors"
  std::optional<std::string> building;  ///< "aces-like" or "office": scans of a drive, not a walk
  std::uint64_t seed = 0;
  std::optional<std::size_t> travels;
  std::optional<std::size_t> width;
  std::optional<std::size_t> height;
  double missing = 0.2;
  double stubs = 0.1;
  std::size_t corridors = 7;
  bool laps = false;
  bool plain = false;  ///< arms as the world lists them
  double turned_deg = 0;
  bool mirrored = false;
  std::size_t people = 2;
  std::string output = "-";
  std::optional<std::string> true_map;
  std::optional<std::string> true_trace;
  std::optional<std::string> true_trajectory;
  std::optional<std::string> svg;
};
inline constexpr std::size_t default_travels = 20;

struct PerceiveCommand {
  std::string log;
  std::string output = "-";
  std::optional<std::string> plots_folder;
  std::optional<std::string> plugin;   ///< detector instead of the one that ships
  std::optional<std::string> program;  ///< the same
  LogOptions laser;
  ScanDetectorOptions detector;
};

struct RunCommand {
  std::string log;
  std::string folder;
  LogOptions laser;
  ScanDetectorOptions detector;
  MapOptions maps;
  std::vector<std::string> assume;  ///< texts of assumptions
  std::size_t models = 5;           ///< ranked and drawn
  bool only_minimal = false;
  double resolution_m = 0.05;  ///< of the global map
  bool json = false;
};

struct EvaluateCommand {
  std::string trajectory;
  std::optional<std::string> relations;  ///< this or the reference
  std::optional<std::string> reference;
  bool json = false;
};

/// Each prints its result on stdout, progress on stderr, and returns the exit code.
int map_command(const MapCommand& command);
int query_command(const QueryCommand& command);
int explain_command(const ExplainCommand& command);
int verify_command(const VerifyCommand& command);
int next_command(const NextCommand& command);
int test_command(const TestCommand& command);
int perceive_command(const PerceiveCommand& command);
int run_command(const RunCommand& command);
int simulate_command(const SimulateCommand& command);
int simulate_drive(const SimulateCommand& command);  ///< where it has a building
int evaluate_command(const EvaluateCommand& command);
int axioms_command(const AxiomOptions& options);
int validate_command(const std::vector<std::string>& files);
std::string version_text();

/// Exit codes, beside those of sysexits.h.                                           [STYLE §5]
enum ExitCode {
  exit_consistent = 0,
  exit_inconsistent = 1,
  exit_undecided = 2,
  exit_usage = 64,
  exit_bad_input = 65,
  exit_plugin = 69,
  exit_internal = 70
};

}  // namespace asterism
