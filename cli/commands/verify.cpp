#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <vector>

#include "cli/asked_maps.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_checks.hpp"
#include "cli/progress.hpp"
#include "cli/text/verify_text.hpp"
#include "io/atomic_file.hpp"
#include "io/json/trace_file.hpp"
#include "mapping/random_traces.hpp"
#include "mapping/verification.hpp"

namespace asterism {
namespace {

using Clock = std::chrono::steady_clock;

struct VerifyCommand {
  AxiomSource axioms;
  std::vector<std::string> traces;  ///< beside those of random worlds
  std::size_t worlds = 40;
  std::uint64_t seed = 0;
  std::optional<std::string> json;  ///< file, or "-"
  std::optional<double> time_limit_s;
};

constexpr auto between_lines = std::chrono::seconds(5);

/// Tells on stderr how far a long comparison is.
class TracesDone {
 public:
  void operator()(std::size_t done, std::size_t traces) {
    const auto now = Clock::now();
    if (now - told_ < between_lines) return;
    told_ = now;
    fmt::print(stderr, "{} of {} traces\n", done, traces);
    std::fflush(stderr);
  }

 private:
  Clock::time_point told_ = Clock::now();
};

std::vector<Trace> traces_of(const VerifyCommand& command) {
  std::vector<Trace> result;
  for (const std::string& file : command.traces) result.push_back(read_trace_file(file));
  for (std::size_t i = 0; i < command.worlds; ++i) result.push_back(random_trace(command.seed + i));
  return result;
}

int run(const VerifyCommand& command) {
  std::vector<Trace> traces = traces_of(command);
  VerifyReport report =
      verify(command.axioms, std::move(traces), deadline_in(command.time_limit_s.value_or(1e8)),
             {.stage_is_over = StageTimes(), .traces_done = TracesDone()});
  report.worlds = command.worlds;
  report.seed = command.seed;
  report.files = command.traces;

  const std::vector<std::string> faults = faults_of(report);
  const std::vector<std::string> undecided = undecided_of(report);
  if (command.json == "-") {
    fmt::print("{}", verification_json(report, faults, undecided));
  } else {
    fmt::print("{}", verify_text(report));
    if (command.json) write_atomically(*command.json, verification_json(report, faults, undecided));
  }
  if (!faults.empty()) return exit_inconsistent;
  return undecided.empty() ? exit_consistent : exit_undecided;
}

void add_options(CLI::App& verify, VerifyCommand& command) {
  verify.add_option("traces", command.traces, "Trace files to compare on, beside random walks");
  add_axiom_options(verify, command.axioms);
  verify.add_option("--worlds", command.worlds, "Random worlds to walk through")
      ->type_name("N")
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  verify.add_option("--seed", command.seed, "Seed of the first of them; the others count on")
      ->check(whole_number)
      ->capture_default_str();
  verify.add_option("--json", command.json, "Write what was found as JSON; -: alone on stdout")
      ->type_name("FILE");
  verify.add_option("--time-limit", command.time_limit_s, "Stop after this many seconds")
      ->type_name("S")
      ->check(seconds);
}

}  // namespace

void add_verify(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "verify", "Check the axioms, and who decides by them", add_options, run,
              R"(Examples:
  asterism verify
  asterism verify --worlds 200 --seed 1000 --json -
  asterism verify --axioms my-axioms examples/aces-stubs.trace.json
Of each axiom: a small model in which it alone fails, or the proof that the others imply it. Of all
together: a model with a travel. On walks through random worlds, and the traces given: that native
engine and solver keep the same maps, and that maps count what the axioms force. With axioms of your
own: what changes against the shipped ones, there and on the visits of the ACES log.
Exit code: 0 all is well, even if an axiom is implied, 1 the axioms allow no travel, or something
differs, 2 undecided or stopped by the time limit, 64 usage, 65 bad input, 70 internal fault or a
result that cannot be written.)");
}

}  // namespace asterism
