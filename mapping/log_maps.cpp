#include "mapping/log_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <span>
#include <system_error>
#include <utility>

#include "mapping/axiom_source.hpp"
#include "metric/alignment.hpp"

namespace asterism {
namespace {

/// What was told, else what an earlier run perceived, else what is perceived now.
Perceived perceived_of(const std::string& log, const LogQuestion& asked, const ReadWatch& watch) {
  if (asked.told) return perceived_as_told(*asked.told, log, asked.laser, watch);
  // A pipe can be read but once.
  std::error_code ignored;
  if (asked.results_before && std::filesystem::is_regular_file(log, ignored)) {
    auto kept = perceived_before(*asked.results_before, log, asked.laser, asked.detector, watch);
    if (kept) return *std::move(kept);
  }
  return perceive(log, asked.laser, asked.detector, watch);
}

Theory theory_of(const LogQuestion& asked, const Trace& trace) {
  return {.planar = asked.maps.theory.planar,
          .assumptions = assumptions_of(asked.assumptions, trace)};
}

ExplainedTrace find_maps(const LogQuestion& asked, const Trace& trace, const Theory& theory,
                         const MapWatch& watch) {
  MapOptions options = asked.maps;
  options.theory = record_of(theory);
  return explain_trace(trace, theory, options, asked.only_minimal, watch);
}

/// @pre  there is one
TopologicalMap first_map(const MapList& list) {
  std::optional<TopologicalMap> map;
  list.for_each_while([&](std::span<const Arrival> arrivals) {
    map = make_map(list.trace, arrivals);
    return false;
  });
  return *std::move(map);
}

/// The explained trace with its maps ranked, and with the reason why no more of it is explained.
ExplainedTrace ranked(ExplainedTrace explained, const LogQuestion& asked,
                      const Perceived& perceived) {
  MapReport& report = explained.report;
  report.ranked =
      explained.parts.empty()
          ? rank(explained.maps, perceived.place_maps, asked.ranking)
          : rank_in_pieces(perceived.trace, explained.parts, perceived.place_maps, asked.ranking);
  if (report.explained_visits && explained.why.empty())
    explained.why =
        why_no_more(perceived.trace, first_map(explained.maps.minimal()), explained.maps.theory());
  return explained;
}

/// Of global maps that are coarser than asked for, or not there.
std::vector<std::string> remarks_on_drawings(const LogMaps& maps, double resolution_m) {
  std::vector<std::string> remarks;
  const auto look_at = [&](const std::string& what, const Grid& map) {
    if (map.resolution_m > resolution_m)
      remarks.push_back(
          fmt::format("{} is drawn in cells of {} m: with cells of {} m it would be "
                      "too large for a picture",
                      what, map.resolution_m, resolution_m));
  };
  for (std::size_t i = 0; i < maps.models.size(); ++i) {
    const DrawnModel& model = maps.models[i];
    const std::string rank = fmt::format("rank {}", i + 1);
    if (model.global_map)
      look_at(rank, *model.global_map);
    else
      remarks.push_back(rank + " is not drawn: " + model.fault);
  }
  look_at("the map by raw odometry", *maps.odometry_map);
  return remarks;
}

}  // namespace

LogMaps map_log(const std::string& file, const LogQuestion& asked, const LogWatch& watch) {
  Perceived perceived = perceived_of(file, asked, watch.read);
  watch.perceived(perceived);
  const Theory theory = theory_of(asked, perceived.trace);
  ExplainedTrace explained = find_maps(asked, perceived.trace, theory, watch.maps);
  watch.explained(explained);
  explained = ranked(std::move(explained), asked, perceived);
  watch.ranked(explained);
  LogMaps maps{std::move(perceived), std::move(explained)};
  maps.models = draw_models(maps.perceived, maps.explained.report.ranked, asked.resolution_m);
  maps.odometry_map = odometry_map(maps.perceived, asked.resolution_m);
  maps.remarks = maps.perceived.remarks;
  if (asked.told) maps.remarks.push_back("the visits are as told by " + asked.told->file);
  std::ranges::copy(remarks_on_drawings(maps, asked.resolution_m),
                    std::back_inserter(maps.remarks));
  return maps;
}

std::vector<RankedMap> rank(const TraceMaps& maps,
                            const std::vector<std::optional<Grid>>& place_maps,
                            const RankingOptions& options) {
  PlaceAlignments alignments(maps.trace(), place_maps);
  Ranking ranking(maps.trace(), std::ref(alignments), options);
  if (maps.are_minimal_alone()) {
    ranking.add([list = maps.minimal()](const auto& f) {
      list.for_each_while([&](std::span<const Arrival> map) {
        f(map);
        return true;
      });
    });
  } else {
    const MapTree& tree = maps.tree();
    for (const auto& hypotheses : tree.by_preference()) {
      ranking.add([&tree, hypotheses](const auto& f) {
        tree.for_each(hypotheses, [&](HypothesisId, std::span<const Arrival> map) { f(map); });
      });
      if (ranking.is_settled()) break;
    }
  }
  std::vector<RankedMap> result = ranking.best();
  // The minimal models stand beside the best, however ill they fit.
  for (RankedMap& minimal : ranking.most_preferred()) {
    const auto is_same = [&](const RankedMap& other) {
      return arrivals(other.map) == arrivals(minimal.map);
    };
    if (std::ranges::none_of(result, is_same)) result.push_back(std::move(minimal));
  }
  return result;
}

std::vector<RankedMap> rank_in_pieces(const Trace& trace, std::span<const TraceMaps> parts,
                                      const std::vector<std::optional<Grid>>& place_maps,
                                      const RankingOptions& options) {
  std::vector<std::vector<RankedMap>> of_parts;
  std::vector<std::size_t> ends;
  std::size_t most = 0;
  for (const TraceMaps& part : parts) {
    const std::size_t first = ends.empty() ? 0 : ends.back();
    ends.push_back(first + part.steps());
    const auto own = std::span(place_maps).subspan(std::min(first, place_maps.size()));
    of_parts.push_back(rank(part, {own.begin(), own.end()}, options));
    most = std::max(most, of_parts.back().size());
  }
  const Trace in_pieces = cut(trace, std::span(ends).first(ends.size() - 1));
  PlaceAlignments alignments(in_pieces, place_maps);
  std::vector<RankedMap> result;
  for (std::size_t i = 0; i < most; ++i) {
    std::vector<Arrival> joined;
    std::size_t places = 0;
    for (const auto& ranked : of_parts) {
      const TopologicalMap& map = ranked[std::min(i, ranked.size() - 1)].map;
      for (std::size_t k = 0; k < map.visits.size(); ++k)
        joined.push_back({PlaceId(places + map.visits[k].index()),
                          k == 0 && places > 0 ? std::nullopt : map.entered[k]});
      places += map.places.size();
    }
    Ranking whole(in_pieces, std::ref(alignments), options);
    whole.add([&](const auto& f) { f(joined); });
    result.push_back(std::move(whole.best().front()));
  }
  return result;
}

}  // namespace asterism
