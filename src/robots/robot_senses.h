#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "robots/legs.h"
#include "robots/person_tracker.h"
#include "robots/ring_scan.h"
#include "robots/scanner.h"
#include "scenario/scene.h"
#include "world/world.h"

namespace crowd {

/// @brief What a robot measures of its own motion.
struct Odometry {
  Pose pose;    ///< in its own frame `odom`, which is that of the robot at the start of the episode
  Twist twist;  ///< of the last tick
};

/// @brief Covariances of the errors of an odometry, of x, y and heading.
struct OdometryCovariance {
  Eigen::Matrix3d pose;   ///< frame `odom` [m^2, m rad, rad^2]
  Eigen::Matrix3d twist;  ///< robot frame [m^2/s^2, m rad/s^2, rad^2/s^2]
};

/// @brief Sensors of all robots of an episode; the same with and without ROS, bit for bit. Not thread-safe.
class RobotSenses {
 public:
  /// @param hides_people all trackers report only people whom a scanner sees, as with `occlusion`
  explicit RobotSenses(const Scene& scene, bool hides_people = false);
  /// @brief Adds the sensors of a robot, as the last one.
  void add(const RobotStart& start);
  /// @brief Removes those of a robot. The errors of the others stay as they are.
  void remove(RobotId robot) { sensors_.erase(sensors_.begin() + robot); }

  /// @brief Takes note of the moves of the last tick. Called once after each tick. The odometry does not notice a robot
  /// that somebody moves to another place.
  void observe(const World& world);
  /// @brief Ranges that the laser scanner of a robot reports now, see writeRanges(). Computed at the first call in a
  /// tick; valid until the next tick or forgetScans().
  const std::vector<float>& ranges(const World& world, RobotId robot);
  /// @brief Points that the rings of its scanner see now, see scanRings(); people are cylinders.
  std::vector<ScanPoint> points(const World& world, RobotId robot);
  /// @brief For each of World::agents(), then of World::obstacles(), whether at least one ray of the scan of ranges()
  /// meets it first, at any range up to the greatest one; noise and dropouts have no effect.
  const std::vector<bool>& visibleBodies(const World& world, RobotId robot);
  /// @brief What the tracker of people of a robot reports now, see PersonTracker. Computed at the first call in a tick;
  /// valid until the next tick. With TrackSpec::keep it is called in each tick.
  const std::vector<PersonTrack>& tracks(const World& world, RobotId robot);
  /// @brief The world has changed since the last tick: scans are computed anew, with the same noise.
  void forgetScans();

  const Odometry& odometry(RobotId robot) const { return sensors_[robot].odometry; }
  /// @brief Linearised propagation of the standard deviations of OdometrySpec along the way so far; zero for an exact
  /// odometry.
  OdometryCovariance covariance(RobotId robot) const;

 private:
  struct Sensor {
    Sensor(const RobotStart& start, std::uint64_t its_number, PersonTracker its_tracker)
        : number(its_number),
          scanner(start.scan),
          tracker(std::move(its_tracker)),
          last_pose{start.position, start.heading},
          deviations(start.odometry) {}

    std::uint64_t number;  // of its random numbers
    Scanner scanner;
    std::optional<std::uint64_t> scanned_at;  // tick
    std::vector<float> ranges;
    std::vector<bool> seen;  // by position of the agent; scratch
    PersonTracker tracker;
    std::optional<std::uint64_t> tracked_at;  // tick
    std::vector<PersonTrack> tracks;
    Odometry odometry;
    Pose last_pose;  // in `map`
    double distance_factor = 1.0;
    double rotation_factor = 1.0;
    double heading_per_metre = 0.0;  // [rad/m]
    OdometrySpec deviations;
    Eigen::Matrix3d derivative = Eigen::Matrix3d::Zero();  // of the pose with respect to the three errors
  };

  void updateWalls(const World& world);
  static void measureMove(const Robot& robot, double tick_duration, Sensor& sensor);
  void scan(const World& world, RobotId robot);
  void addPeople(const World& world, SeenPeople people);
  /// Adds obstacles, of recorded people what the scanner sees of people.
  void addObstacles(const World& world, SeenPeople people);
  /// Adds the other robots.
  void addRobots(const World& world, RobotId robot);

  std::uint64_t seed_;
  bool hides_people_;
  std::shared_ptr<const OccupancyMap> map_;  // null: none
  bool has_legs_ = false;
  Gait gait_;
  std::vector<Sensor> sensors_;  // by robot
  std::uint64_t next_number_ = 0;
  WallIndex walls_;                        // without a margin, unlike that of the world, which makes rays faster
  std::optional<std::uint64_t> walls_of_;  // World::layoutChanges()
  std::vector<ScanTarget> targets_;        // scratch
  std::vector<ScanEdge> edges_;            // scratch
};

}  // namespace crowd
