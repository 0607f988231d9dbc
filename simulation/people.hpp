#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "simulation/laser.hpp"
#include "simulation/world.hpp"

namespace asterism {

/// People who walk the corridors round a robot, in and out of doors that are never seen. For one
/// thread at a time.
class People {
 public:
  /// @pre  the world has segments; it must outlive this
  People(const World& world, std::size_t count, RandomEngine engine);

  /// Time goes by. Nobody walks into the robot: who comes near turns round, or is gone.
  void walk(double seconds, Point2 robot);

  /// Where they are now, in the world's frame.
  const std::vector<Person>& positions() const noexcept { return positions_; }

 private:
  /// On the way along a corridor from a gateway.
  struct Walker {
    PlaceArm gateway;
    double gone_m;
    double left_m;  ///< of the corridor's middle
    double speed_m_per_s;
  };

  Point2 position(const Walker& walker) const;
  double length_m(PlaceArm gateway) const;
  Walker turned_round(const Walker& walker) const;
  Walker come(Point2 robot);
  void step(Walker& walker, double seconds, Point2 robot);

  const World* world_;
  RandomEngine engine_;
  std::size_t count_;
  std::vector<Walker> walkers_;
  std::vector<Person> positions_;
};

}  // namespace asterism
