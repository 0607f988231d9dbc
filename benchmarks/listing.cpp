#include "benchmarks/listing.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <variant>

#include "benchmarks/asp_facts.hpp"
#include "benchmarks/heap.hpp"
#include "benchmarks/measure.hpp"
#include "io/json/maps_file.hpp"
#include "io/json/trace_file.hpp"

namespace asterism {
namespace {

/// The number that follows these words in what a program said.
std::optional<std::uint64_t> number_after(const std::string& output, const std::string& words) {
  const std::size_t at = output.find(words);
  if (at == std::string::npos) return std::nullopt;
  return std::stoull(output.substr(at + words.size()));
}

}  // namespace

Listing list_with_tree(const Trace& trace, const MapTree::Options& options, std::size_t runs) {
  Listing listing;
  listing.cpu_s = listing.wall_s = median(runs, [&] {
    MapTree tree(options);
    const Stopwatch stopwatch;
    tree.extend(trace.visits);
    const double wall_s = stopwatch.seconds();
    listing.maps = tree.size();
    return wall_s;
  });
  return listing;
}

OnlineListing list_online(const Trace& trace, const MapTree::Options& options, std::size_t runs) {
  constexpr double many = 1000;
  OnlineListing online;
  online.all.wall_s = median(runs, [&] {
    online = {};
    const std::size_t heap_before = heap_bytes();
    MapTree tree(options);
    double all_s = 0;
    for (const Visit& visit : trace.visits) {
      reset_heap_peak();
      const Stopwatch stopwatch;
      tree.extend(visit);
      const double visit_s = stopwatch.seconds();
      all_s += visit_s;
      online.slowest_s = std::max(online.slowest_s, visit_s);
      const auto hypotheses = static_cast<double>(tree.size());
      if (hypotheses < many) continue;
      const auto keep_largest = [&](std::optional<double>& bytes_each, std::size_t bytes) {
        bytes_each = std::max(bytes_each.value_or(0), static_cast<double>(bytes) / hypotheses);
      };
      keep_largest(online.tree_bytes_each, tree.memory_bytes());
      keep_largest(online.peak_bytes_each, heap_peak_bytes() - heap_before);
    }
    online.all.maps = tree.size();
    return all_s;
  });
  return online;
}

bool Programs::has_clingo() const {
  try {
    return run_process({"clingo", "--version"}, 10).exit_code == 0;
  } catch (const std::system_error&) {
    return false;
  }
}

Listing Programs::clingo(const Trace& trace, const std::string& option, double time_limit_s) const {
  const std::string facts = scratch_.file("facts.lp");
  std::ofstream(facts) << asp_facts(trace);
  std::vector<std::string> command{"clingo", "0", "-q"};
  if (!option.empty()) command.push_back(option);
  command.insert(command.end(), {benchmarks_ + "/maps.lp", facts});
  const ProcessResult result = run_process(command, time_limit_s);
  if (!result.exit_code) return {std::nullopt, result.wall_s, result.cpu_s};
  return {number_after(result.output, "Models       : "), result.wall_s, result.cpu_s};
}

Listing Programs::asterism(const Trace& trace, std::size_t runs) const {
  const std::string file = scratch_.file("trace.json");
  write_trace_file(file, trace);
  const std::string maps_file = scratch_.file("maps.json");
  Listing listing;
  listing.cpu_s = listing.wall_s = median(runs, [&] {
    const ProcessResult result =
        run_process({asterism_, "map", file, "--certify", "0", "--json", maps_file}, 600);
    if (result.exit_code != 0)
      throw std::runtime_error(asterism_ + ": found a failure; expected exit code 0");
    return result.wall_s;
  });
  listing.maps = std::get<MapReport>(read_any_maps_file(maps_file)).consistent;
  return listing;
}

}  // namespace asterism
