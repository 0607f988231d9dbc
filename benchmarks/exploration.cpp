#include "benchmarks/exploration.hpp"

#include <cmath>
#include <deque>
#include <set>
#include <stdexcept>

#include "engine/tree/map_tree.hpp"
#include "simulation/corridor_world.hpp"
#include "simulation/grid_world.hpp"

namespace asterism {
namespace {

constexpr std::size_t fewest_travels = 12;
constexpr std::size_t most_travels = 20;
constexpr std::uint64_t fewest_maps = 20;
constexpr std::uint64_t most_maps = 5000;

/// The robot in its world, and the maps it has made up of it. Stars are listed as the world lists
/// them, so that an arm has one number in both.
class Robot {
 public:
  Robot(const World& world, const Route& route, bool planar)
      : world_(world), at_{route.start, 0}, tree_({.theory = {.planar = planar}}) {
    RandomEngine undisguised(0);
    for (const Visit& visit : walk_along(world, route, false, undisguised).trace.visits)
      grow(visit);
    for (const PlaceArm& gateway : route.gateways) use(gateway), move(gateway);
    seen_ = {at_.place};
    used_before_ = used_;
  }

  const MapTree& tree() const { return tree_; }
  const World& world() const { return world_; }
  PlaceArm at() const { return at_; }
  bool has_used(PlaceArm gateway) const { return used_.contains(gateway); }
  PlaceArm gateway(std::size_t turn) const { return clockwise(at_, turn); }
  PlaceArm clockwise(PlaceArm arm, std::size_t turn) const {
    return {arm.place, world_.places[arm.place.index()].star.clockwise(arm.arm, turn)};
  }

  void travel(PlaceArm gateway) {
    tree_.leave(gateway.arm);
    use(gateway);
    move(gateway);
    travelled_.insert(std::min(gateway, at_));
    seen_.insert(at_.place);
    grow({.star = world_.places[at_.place.index()].star, .entered_by = at_.arm});
  }

  Explored explored() const {
    return {.maps = tree_.size(),
            .places = seen_.size(),
            .segments = travelled_.size(),
            .new_segments = (used_.size() - used_before_.size()) / 2};
  }

 private:
  void grow(const Visit& visit) {
    if (tree_.extend(visit) != MapTree::Growth::complete || tree_.size() == 0)
      throw std::logic_error("the tree stopped growing");
  }
  void move(PlaceArm gateway) { at_ = world_.segments.at(gateway); }
  void use(PlaceArm gateway) { used_.insert({gateway, world_.segments.at(gateway)}); }

  const World& world_;
  PlaceArm at_;  ///< the arm come in by
  MapTree tree_;
  std::set<PlaceArm> used_;  ///< both gateways of each segment travelled
  std::set<PlaceArm> used_before_;
  std::set<PlaceId> seen_;
  std::set<PlaceArm> travelled_;  ///< since the start, the smaller gateway of each segment
};

std::vector<PlaceArm> gateways_of(const Robot& robot, PlaceArm arrived) {
  const Star& star = robot.world().places[arrived.place.index()].star;
  std::vector<PlaceArm> result;
  for (std::size_t step = 1; step <= star.size(); ++step)
    if (const PlaceArm gateway = robot.clockwise(arrived, step); star.has_gateway(gateway.arm))
      result.push_back(gateway);
  return result;
}

std::vector<PlaceArm> way_of(const Robot& robot, const Turns& turns) {
  std::vector<PlaceArm> way;
  PlaceArm arrived = robot.at();
  for (const std::size_t turn : turns) {
    way.push_back(robot.clockwise(arrived, turn));
    arrived = robot.world().segments.at(way.back());
  }
  return way;
}

/// The shortest way that ends with a gateway not used yet; none where all have been.
std::vector<PlaceArm> way_to_unexplored(const Robot& robot) {
  std::deque<std::pair<PlaceArm, std::vector<PlaceArm>>> next{{robot.at(), {}}};
  std::set<PlaceId> reached{robot.at().place};
  for (; !next.empty(); next.pop_front()) {
    const auto& [arrived, way] = next.front();
    for (const PlaceArm& gateway : gateways_of(robot, arrived)) {
      std::vector<PlaceArm> longer = way;
      longer.push_back(gateway);
      if (!robot.has_used(gateway)) return longer;
      const PlaceArm to = robot.world().segments.at(gateway);
      if (reached.insert(to.place).second) next.emplace_back(to, std::move(longer));
    }
  }
  return {};
}

std::vector<PlaceArm> next_way(const Robot& robot, Explorer explorer, RandomEngine& engine,
                               const ExitBounds& bounds) {
  if (explorer == Explorer::advised)
    return way_of(robot, exits(robot.tree(), bounds)->exits.front().turns);
  if (explorer == Explorer::nearest_unexplored)
    if (auto way = way_to_unexplored(robot); !way.empty()) return way;
  const std::vector<PlaceArm> ways = gateways_of(robot, robot.at());
  return {ways[below(ways.size(), engine)]};
}

}  // namespace

std::optional<Exploration> exploration(std::uint64_t seed) {
  RandomEngine engine(seed);
  Exploration start{.world = seed % 2 == 0
                                 ? grid_world({.width = 5, .height = 5, .stubs = 0}, engine)
                                 : corridor_world({.ends_blind = 0, .min_places = 15}, engine),
                    .route = {PlaceId(0), {}},
                    .maps = 0};
  const Route whole = random_route(start.world, {.travels = most_travels}, engine);
  for (std::size_t travels = fewest_travels; travels <= most_travels; ++travels) {
    start.route = {
        whole.start,
        {whole.gateways.begin(), whole.gateways.begin() + static_cast<std::ptrdiff_t>(travels)}};
    MapTree tree;
    if (tree.extend(walk_along(start.world, start.route, false, engine).trace.visits) !=
        MapTree::Growth::complete)
      return std::nullopt;
    start.maps = tree.size();
    if (start.maps > most_maps) return std::nullopt;
    if (start.maps >= fewest_maps) return start;
  }
  return std::nullopt;
}

Explored explore(const Exploration& start, Explorer explorer, bool planar, std::size_t travels,
                 RandomEngine& engine, const ExitBounds& bounds) {
  Robot robot(start.world, start.route, planar);
  for (std::size_t done = 0; done < travels;)
    for (const PlaceArm& gateway : next_way(robot, explorer, engine, bounds))
      if (done < travels) robot.travel(gateway), ++done;
  return robot.explored();
}

MeanLogRatio mean_log_ratio(const std::vector<Explored>& ours,
                            const std::vector<Explored>& theirs) {
  const auto count = static_cast<double>(ours.size());
  double sum = 0;
  double squares = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double ratio =
        std::log(static_cast<double>(ours[i].maps) / static_cast<double>(theirs.at(i).maps));
    sum += ratio;
    squares += ratio * ratio;
  }
  const double mean = sum / count;
  const double variance = (squares - count * mean * mean) / (count - 1);
  return {mean, 1.96 * std::sqrt(variance / count)};
}

}  // namespace asterism
