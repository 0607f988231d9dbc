#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/verify_report.hpp"
#include "cli/verify_text.hpp"
#include "cli/verify_worlds.hpp"
#include "io/atomic_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto between_lines = std::chrono::seconds(5);

/// Tells on stderr how far a long comparison is.
class TracesDone {
 public:
  explicit TracesDone(std::size_t traces) : traces_(traces) {}

  void operator()(std::size_t done) {
    const auto now = Clock::now();
    if (now - told_ < between_lines) return;
    told_ = now;
    fmt::print(stderr, "{} of {} traces\n", done, traces_);
    std::fflush(stderr);
  }

 private:
  std::size_t traces_;
  Clock::time_point told_ = Clock::now();
};

/// Every axiom of the set; of the shipped set also the optional ones that are off, each put to it
/// alone.
std::vector<AxiomFinding> findings_of(const VerifyCommand& command, const AxiomSet& axioms,
                                      Deadline deadline) {
  std::vector<AxiomFinding> result;
  for (const Axiom& axiom : axioms.axioms())
    result.push_back({axiom, false, independence(axiom, axioms, deadline)});
  if (command.axioms.folder) return result;
  for (const std::string& name : AxiomSet::optional_names()) {
    if (axioms.contains(name)) continue;
    std::vector<std::string> names = command.axioms.optional;
    names.push_back(name);
    const AxiomSet with = AxiomSet::shipped(names);
    const auto axiom = std::ranges::find(with.axioms(), name, &Axiom::name);
    result.push_back({*axiom, true, independence(*axiom, with, deadline)});
  }
  return result;
}

std::vector<Trace> traces_of(const VerifyCommand& command) {
  std::vector<Trace> result;
  for (const std::string& file : command.traces) result.push_back(read_trace_file(file));
  for (std::size_t i = 0; i < command.worlds; ++i) result.push_back(random_trace(command.seed + i));
  return result;
}

}  // namespace

int verify_command(const VerifyCommand& command) {
  const AxiomSet axioms = command.axioms.read();
  std::vector<Trace> traces = traces_of(command);
  const Deadline deadline = deadline_in(command.time_limit_s.value_or(1e8));
  StageTimes done;

  VerifyReport report;
  report.axioms = command.axioms.folder.value_or("shipped");
  report.optional_axioms = command.axioms.optional;
  std::ranges::sort(report.optional_axioms);
  report.worlds = command.worlds;
  report.seed = command.seed;
  report.files = command.traces;
  report.findings = findings_of(command, axioms, deadline);
  report.together = model_with_travel(axioms, deadline);
  done("axioms");
  report.engines = compare_engines(axioms, traces, deadline, TracesDone(traces.size()));
  done("engines");
  if (command.axioms.folder) {
    traces.push_back(ring_trace());
    report.change = compare_with_shipped(axioms, traces, deadline, TracesDone(traces.size()));
    done("change");
  }

  if (command.json != "-") fmt::print("{}", verify_text(report));
  if (command.json == "-")
    fmt::print("{}", verify_json(report));
  else if (command.json)
    write_atomically(*command.json, verify_json(report));
  if (!faults_of(report).empty()) return exit_inconsistent;
  return undecided_of(report).empty() ? exit_consistent : exit_undecided;
}

}  // namespace asterism
