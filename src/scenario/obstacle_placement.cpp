#include "scenario/obstacle_placement.h"

#include <string>
#include <vector>

#include "geometry/impact.h"
#include "scenario/goal_checks.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

ObstaclePosition positionOf(const ObstacleGroup& group) {
  if (group.between) return ObstaclePosition::BETWEEN;
  return group.position.isFixed() ? ObstaclePosition::FIXED : ObstaclePosition::DRAWN;
}

/// Draws obstacles of a scenario.
class ObstaclePlacement {
 public:
  ObstaclePlacement(const Scenario& scenario, KeyedRandom& random, const PlacedBodies& placed, const Scene& scene)
      : scenario_(scenario), random_(random), placed_(placed), scene_(scene) {}

  Obstacle draw(const ObstacleGroup& group, const Label& label) {
    const bool rests = group.motion == ObstaclePath::Kind::AT_REST;
    for (int tries = 0; tries < MAX_TRIES; ++tries) {
      const Vector2 start = drawStart(group, label);
      const double radius = group.radius.draw(random_);
      const bool fits =
          positionOf(group) == ObstaclePosition::FIXED ||
          (!placed_.findBlocker(start, radius, DRAWN_GAP) && !(rests && placed_.isNearGoal(start, radius)));
      if (fits) return {drawPath(group, start, label), radius};
    }
    refuse(scenario_, label, label.text() + ": no free place found in " + std::to_string(MAX_TRIES) + " tries");
  }

 private:
  Vector2 drawStart(const ObstacleGroup& group, const Label& label) {
    if (!group.between) return group.position.draw(random_, scene_.free_space.get());
    if (group.between->agent >= scene_.agents.size()) {
      refuse(scenario_, label,
             label.text() + ".position.between.agent: expected the number of an agent, 0 to " +
                 std::to_string(scene_.agents.size() - 1) + ", got " + std::to_string(group.between->agent));
    }
    return group.between->draw(scene_.agents[group.between->agent], random_);
  }

  ObstaclePath drawPath(const ObstacleGroup& group, const Vector2& start, const Label& label) {
    if (group.motion == ObstaclePath::Kind::AT_REST) return ObstaclePath::atRest(start);
    if (group.motion == ObstaclePath::Kind::STRAIGHT) return ObstaclePath::straight(start, group.velocity);
    std::vector<Vector2> points = {start};
    for (const Region& waypoint : group.waypoints) {
      points.push_back(waypoint.draw(random_, scene_.free_space.get()));
    }
    const double speed = group.speed.draw(random_);
    try {
      const bool loop = group.motion == ObstaclePath::Kind::LOOP;
      return loop ? ObstaclePath::loop(points, speed) : ObstaclePath::toAndFro(points, speed);
    } catch (const InputError& error) {
      refuse(scenario_, label, label.text() + ": " + error.what());
    }
  }

  const Scenario& scenario_;
  KeyedRandom& random_;
  const PlacedBodies& placed_;
  const Scene& scene_;
};

}  // namespace

void placeObstacles(const Scenario& scenario, ObstaclePosition position, KeyedRandom& random, const StopRequest& stop,
                    PlacedBodies& placed, Scene& scene) {
  ObstaclePlacement placement(scenario, random, placed, scene);
  forEachBody("obstacles", scenario.obstacles, stop,
              [&](const ObstacleGroup& group, const Label& label, std::size_t index) {
                if (positionOf(group) != position) return;
                const Obstacle obstacle = placement.draw(group, label);
                placed.add(label, obstacle.path.position(0.0), obstacle.radius, !obstacle.path.moves());
                scene.obstacles[index] = obstacle;
              });
}

}  // namespace crowd
