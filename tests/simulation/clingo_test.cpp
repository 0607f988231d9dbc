#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>

#include "benchmarks/asp_facts.hpp"
#include "benchmarks/minimal_traces.hpp"
#include "benchmarks/traces.hpp"
#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"
#include "simulation/walk.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/known_traces.hpp"

using namespace asterism;

namespace {

const std::string folder = ASTERISM_SOURCE_DIR "/benchmarks/";

bool has_clingo() { return std::system("clingo --version > /dev/null 2>&1") == 0; }

/// What clingo prints about the trace; options and files come before its facts.
std::string clingo(const std::string& arguments, const Trace& trace) {
  const auto facts = std::filesystem::temp_directory_path() /
                     ("asterism-facts-" + std::to_string(getpid()) + ".lp");
  std::ofstream(facts) << asp_facts(trace);
  const std::string command = "clingo " + arguments + " " + facts.string() + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("clingo: found no process; expected one");
  std::string output;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output += static_cast<char>(c);
  pclose(pipe);
  std::filesystem::remove(facts);
  return output;
}

/// The number that stands after a key and a colon, if the key is there.
std::optional<std::size_t> number(const std::string& output, const std::string& key) {
  const std::size_t line = output.find("\n" + key);
  if (line == std::string::npos) return std::nullopt;
  return std::stoul(output.substr(output.find(':', line) + 1));
}

/// FNV-1a of the trace, written as facts.
std::uint64_t fingerprint(const Trace& trace) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : asp_facts(trace))
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

std::size_t count(const Trace& trace) {
  return number(clingo("0 -q " + folder + "maps.lp", trace), "Models").value();
}

}  // namespace

TEST_CASE("clingo counts the known maps, minimal ones too", "[benchmarks][clingo]") {
  if (!has_clingo()) {
    WARN("clingo is not installed");
    return;
  }
  for (const KnownTrace& known : known_traces()) {
    INFO(known.trace.name);
    CHECK(count(known.trace) == known.all.consistent);

    const std::string output =
        clingo("0 -q --opt-mode=optN " + folder + "maps.lp " + folder + "minimal.lp", known.trace);
    // clingo leaves the line out where there is one.
    CHECK(number(output, "  Optimal").value_or(1) == known.all.minimal_visits.size());
    CHECK(output.find("Optimization : " + std::to_string(known.all.minimal_paths) + " " +
                      std::to_string(known.all.minimal_places)) != std::string::npos);
  }
}

TEST_CASE("clingo counts as brute force does", "[benchmarks][clingo][property]") {
  if (!has_clingo()) {
    WARN("clingo is not installed");
    return;
  }
  for (unsigned seed = 0; seed < 120; ++seed) {
    INFO("seed " << seed);
    RandomEngine engine(seed);
    const World world = seed % 2 == 0 ? grid_world({.width = 3, .height = 3}, engine)
                                      : corridor_world({.corridors = 12}, engine);
    const Trace trace = walk(world, {.travels = 6 + seed % 8}, engine).trace;
    CHECK(count(trace) == every_map_by_visit(trace).back().size());
  }
}

TEST_CASE("the benchmark traces are what they were", "[benchmarks]") {
  for (const BenchmarkTrace& benchmark : benchmark_traces) {
    const Trace trace = make_trace(benchmark);
    CHECK_NOTHROW(require_valid(trace));
    CHECK(trace.visits.size() == benchmark.travels + 1);
  }
}

TEST_CASE("the walks that grow are what they were", "[benchmarks]") {
  const auto [walk, name, hash] =
      GENERATE(std::tuple(grid_walks[1], "4 × 4, 40 travels", 0xb76e3a5417ecd393ULL),
               std::tuple(grid_walks[3], "6 × 6, 100 travels", 0x7effd7cdf149aa90ULL),
               std::tuple(corridor_walks[2], "10 corridors, 45 travels", 0x1f7c4133bd0701d8ULL));
  const Trace trace = make_trace(walk, 1);
  CHECK_NOTHROW(require_valid(trace));
  CHECK(trace.name == name);
  CHECK(fingerprint(trace) == hash);
}
