#include "engine/ask/exits.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/id_vector.hpp"
#include "engine/ask/replay.hpp"

namespace asterism {
namespace {

constexpr std::uint64_t work_between_questions = 1 << 15;  ///< some tens of milliseconds

/// What the maps say of one travel. Whole numbers alone, so that nothing depends on their order.
class Tally {
 public:
  Tally(Turns way, std::size_t views) : turns(std::move(way)), known_(views) {}

  void add(const Replay& map, ArmId gateway) {
    const auto to = map.engine().across(gateway);
    if (to) {
      ++known_[map.table().view(*to)];
      return;
    }
    views_.clear();
    map.engine().for_each_closure(gateway, [&](ArmId y) { views_.push_back(map.table().view(y)); });
    if (alike_.size() <= views_.size()) alike_.resize(views_.size() + 1);
    Alike& alike = alike_[views_.size()];
    alike.closures.resize(known_.size());
    ++alike.maps;
    for (const ViewId view : views_) ++alike.closures[view];
  }

  /// Whether every map has the segment, and all expect to see the same.
  bool is_sure(std::uint64_t maps) const { return std::ranges::count(known_, maps) > 0; }

  /// @param new_place  chance of each view at a new place
  Exit exit(std::uint64_t maps, const IdVector<ViewId, double>& new_place,
            const IdVector<ViewId, Star>& stars) const;

  Turns turns;

 private:
  /// Maps in which so many gateways may be at the other end.
  struct Alike {
    std::uint64_t maps = 0;
    IdVector<ViewId, std::uint64_t> closures = {};
  };

  IdVector<ViewId, std::uint64_t> known_;  ///< maps that expect it
  std::vector<Alike> alike_;               ///< by the number of closures
  std::vector<ViewId> views_;
};

Exit Tally::exit(std::uint64_t maps, const IdVector<ViewId, double>& new_place,
                 const IdVector<ViewId, Star>& stars) const {
  Exit exit;
  exit.turns = turns;
  double is_new = 0;  // maps, in each the share of its ways on
  IdVector<ViewId, double> is_seen(known_.size());
  IdVector<ViewId, std::uint64_t> closures(known_.size());
  for (std::size_t n = 0; n < alike_.size(); ++n) {
    if (alike_[n].maps == 0) continue;
    const auto ways = static_cast<double>(n + 1);
    exit.open += alike_[n].maps;
    is_new += static_cast<double>(alike_[n].maps) / ways;
    for (const ViewId view : IdRange<ViewId>(known_.size())) {
      closures[view] += alike_[n].closures[view];
      is_seen[view] += static_cast<double>(alike_[n].closures[view]) / ways;
    }
  }
  double anything_else = 1;
  double expected = 0;
  const auto all = static_cast<double>(maps);
  for (const ViewId view : IdRange<ViewId>(known_.size())) {
    exit.known += known_[view];
    if (known_[view] + closures[view] == 0) continue;
    const std::uint64_t left = known_[view] + closures[view] + exit.open;
    const double chance =
        (static_cast<double>(known_[view]) + is_seen[view] + is_new * new_place[view]) / all;
    exit.outlooks.push_back({stars[view], left, chance});
    anything_else -= chance;
    expected += chance * static_cast<double>(left);
  }
  std::ranges::stable_sort(exit.outlooks, std::ranges::greater{}, &Outlook::chance);
  if (exit.open > 0) {
    const double chance = std::max(anything_else, 0.0);
    exit.outlooks.push_back({std::nullopt, exit.open, chance});
    expected += chance * static_cast<double>(exit.open);
  }
  exit.expected_left = std::round(expected * 1e6) / 1e6;
  exit.tells = !is_sure(maps);
  return exit;
}

/// Rows of travels, told apart by the gateways at which they end. Two that end at one gateway in
/// every map are twins.
class Twins {
 public:
  explicit Twins(std::size_t rows) : kind_(rows, 0), kinds_(std::min<std::size_t>(rows, 1)) {}

  bool are_possible() const { return kinds_ < kind_.size(); }

  /// @param gateways  at which the rows end in one more map
  void add(std::span<const ArmId> gateways) {
    std::map<std::pair<std::size_t, ArmId>, std::size_t> finer;
    for (std::size_t row = 0; row < kind_.size(); ++row)
      kind_[row] = finer.try_emplace({kind_[row], gateways[row]}, finer.size()).first->second;
    kinds_ = finer.size();
  }
  bool has_earlier(std::size_t row) const {
    return are_possible() && std::ranges::count(std::span(kind_).first(row), kind_[row]) > 0;
  }

 private:
  std::vector<std::size_t> kind_;
  std::size_t kinds_;
};

/// Looks out from one place after another, those nearest first.
class Search {
 public:
  Search(const MapList& maps, const ExitBounds& bounds, const Stop& stop)
      : maps_(maps), bounds_(bounds), stop_(stop), map_(maps) {
    const ArmTable& table = map_.table();
    IdVector<ViewId, std::optional<Star>> stars(table.views());
    new_place_.resize(table.views());
    for (const VisitId k : table.all_visits())
      for (const ArmId arm : table.arms(k)) {
        const ViewId view = table.view(arm);
        if (!stars[view])
          stars[view] = star_as_seen(table.trace().visits[k.index()].star, table.position(arm));
        if (table.has_gateway(arm))
          new_place_[view] +=
              1.0 / static_cast<double>((table.visits() + 1) * table.gateways(k).size());
      }
    for (auto& star : stars) stars_.push_back(*std::move(star));
  }

  std::optional<Exits> run() {
    Exits result;
    std::vector<Turns> lookouts{{}};
    std::size_t looked_out = 0;
    for (std::size_t travels = 1; !lookouts.empty(); ++travels) {
      const std::size_t room = travels > bounds_.travels ? 0 : bounds_.places - looked_out;
      if (lookouts.size() > room) {
        result.complete = false;
        lookouts.resize(room);
      }
      looked_out += lookouts.size();
      if (lookouts.empty()) break;
      if (!look_out(lookouts)) return std::nullopt;
      lookouts = take(result.exits);
    }
    std::ranges::sort(result.exits, {}, [](const Exit& exit) {
      return std::tuple(!exit.tells, exit.expected_left, exit.turns.size(), exit.turns);
    });
    return result;
  }

 private:
  /// Fills tallies_ with all exits of the places to which these turns lead.
  bool look_out(std::span<const Turns> lookouts) {
    tallies_.clear();
    std::vector<std::size_t> first{0};  // tally of each lookout, one more at the end
    std::uint64_t maps = 0;
    std::uint64_t work = 0;
    bool stopped = false;
    maps_.for_each_while([&](std::span<const Arrival> map) {
      map_.go_to(map);
      for (std::size_t i = 0; i < lookouts.size(); ++i) {
        const ArmId arrived = follow(lookouts[i]);
        if (maps == 0) add_tallies(lookouts[i], arrived), first.push_back(tallies_.size());
        for (std::size_t t = first[i]; t < first[i + 1]; ++t)
          tallies_[t].add(map_, map_.table().clockwise(arrived, tallies_[t].turns.back()));
      }
      if (maps == 0) twins_ = Twins(rows_.size() + tallies_.size());
      if (twins_.are_possible()) twins_.add(ends_of_rows());
      ++maps;
      work += tallies_.size();
      if (work >= work_between_questions) {
        work = 0;
        stopped = stop_.is_due({.maps = maps});
      }
      return !stopped;
    });
    return !stopped;
  }

  /// The places are different ones in each map, but look the same.
  void add_tallies(const Turns& lookout, ArmId arrived) {
    const ArmTable& table = map_.table();
    for (std::size_t step = 0; step < table.star_size(table.visit_of(arrived)); ++step) {
      if (!table.has_gateway(table.clockwise(arrived, step))) continue;
      Turns turns = lookout;
      turns.push_back(step);
      tallies_.emplace_back(std::move(turns), table.views());
    }
  }

  ArmId follow(std::span<const std::size_t> turns) const {
    ArmId arrived = map_.arrived();
    for (const std::size_t turn : turns)
      arrived = map_.engine().across(map_.table().clockwise(arrived, turn)).value();
    return arrived;
  }

  ArmId gateway(const Turns& turns) const {
    return map_.table().clockwise(follow(std::span(turns).first(turns.size() - 1)), turns.back());
  }
  std::vector<ArmId> ends_of_rows() const {
    std::vector<ArmId> ends;
    for (const Turns& row : rows_) ends.push_back(gateway(row));
    for (const Tally& tally : tallies_) ends.push_back(gateway(tally.turns));
    return ends;
  }

  /// Lists the exits found, none of them twice. Among all maps of a trace there are no twins: one
  /// of them is that in which no open gateway ever led back to a place known, and its segments,
  /// which all maps have, are a tree. But minimal models may have loops in common.
  ///
  /// @return  where to look out next
  std::vector<Turns> take(std::vector<Exit>& exits) {
    std::vector<Turns> next;
    const std::size_t before = rows_.size();
    for (std::size_t t = 0; t < tallies_.size(); ++t) {
      const Tally& tally = tallies_[t];
      if (twins_.has_earlier(before + t)) continue;
      rows_.push_back(tally.turns);
      const bool is_sure = tally.is_sure(maps_.size);
      const bool is_first = tally.turns.size() == 1;
      if (!is_sure || is_first) exits.push_back(tally.exit(maps_.size, new_place_, stars_));
      if (is_sure && (is_first || tally.turns.back() != 0)) next.push_back(tally.turns);
    }
    return next;
  }

  const MapList& maps_;
  const ExitBounds& bounds_;
  const Stop& stop_;
  Replay map_;
  IdVector<ViewId, Star> stars_;
  IdVector<ViewId, double> new_place_;
  std::vector<Turns> rows_;  ///< to every gateway met at lookouts before
  std::vector<Tally> tallies_;
  Twins twins_{0};
};

}  // namespace

std::optional<Exits> exits(const MapList& maps, const ExitBounds& bounds, const Stop& stop) {
  return Search(maps, bounds, stop).run();
}

}  // namespace asterism
