#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "social_crowd/episode.h"
#include "social_crowd/q_table.h"
#include "social_crowd/results.h"
#include "social_crowd/scenario.h"

namespace crowd::library {

/// @brief A robot of a scenario file: what it can do, and what its scanner is.
struct RobotDescription {
  std::string name;
  std::string drive;             ///< differential, holonomic, ackermann
  double max_speed = 0.0;        ///< [m/s]
  double max_rotation = 0.0;     ///< [rad/s]
  double radius = 0.0;           ///< of the smallest disc round its base that contains its footprint [m]
  std::uint32_t rays = 0;        ///< of its scanner
  double first_angle = 0.0;      ///< of the first ray, sensor frame [rad]
  double angle_increment = 0.0;  ///< [rad]
  double min_range = 0.0;        ///< [m]
  double max_range = 0.0;        ///< [m]
};

/// @brief What the robots of a RobotBatch know, an element or a row for each. Lengths are in metres, angles in radians.
/// The arrays keep their sizes and addresses as long as the batch exists.
struct RobotArrays {
  static constexpr std::size_t PERSON = 5;  ///< numbers of a person: x, y, velocity x and y, radius

  std::vector<double> pose;                ///< x, y, heading; `map`
  std::vector<double> twist;               ///< ahead, left [m/s], rotation [rad/s]; of the last tick
  std::vector<double> goal;                ///< x ahead, y left; zeros without a goal
  std::vector<double> remaining_distance;  ///< straight from here via all goals that are left; 0 without a goal
  std::vector<double> clearance;           ///< from its footprint to the nearest body of a person; infinite: nobody
  std::vector<std::uint32_t> contacts;     ///< number of people in contact with it in the ticks of this step
  std::vector<std::uint32_t> contacts_by_robot;   ///< of these: it moved into them
  std::vector<std::uint32_t> contacts_by_person;  ///< of these: they moved into it
  std::vector<std::uint8_t> has_goal;
  std::vector<std::uint8_t> arrived;  ///< at its last goal
  std::vector<std::uint8_t> blocked;  ///< stopped by an impact in the last tick
  std::vector<std::uint8_t> over;     ///< the episode is over; see Episode::isOver()
  std::vector<std::uint64_t> tick;
  std::vector<float> scan;                  ///< ranges, as the scanner reports them (REP 117)
  std::vector<double> people;               ///< whom the scanner sees, robot frame, nearest rim first; then zeros
  std::vector<std::uint32_t> people_count;  ///< number of them
};

/// @brief Which episode an element of a RobotBatch begins.
struct EpisodeStart {
  std::size_t element = 0;
  std::size_t scenario = 0;  ///< index of the scenario
  std::uint64_t seed = 1;    ///< with the instance: of the scene, see Episode
  std::uint64_t instance = 0;
  std::uint64_t number = 0;  ///< of the episode, on which the gait of agents depends
};

struct RobotBatchOptions {
  std::size_t size = 1;          ///< number of episodes
  std::string robot;             ///< its name; empty: the first one of the scenario. All others stand
  std::uint32_t ticks = 1;       ///< that a command holds
  bool scan = true;              ///< whether scans are computed
  std::uint32_t max_people = 0;  ///< rows of RobotArrays::people
  unsigned threads = 0;          ///< that share the episodes; 0: one per processor. Results do not depend on it
};

/// @brief Episodes side by side, in each of which one robot is commanded from outside, and a Q-table decides for the
/// people. The same starts and commands give the same numbers, bit for bit, as `~step_robots` through ROS. Use an
/// object from one thread at a time.
class RobotBatch {
 public:
  /// @throws InputError unless all scenarios have the robot, with the same drive, greatest speeds and scanner
  RobotBatch(std::vector<Scenario> scenarios, const QTable& table, const RobotBatchOptions& options);
  RobotBatch(RobotBatch&&) noexcept;
  RobotBatch& operator=(RobotBatch&&) noexcept;
  ~RobotBatch();

  const RobotDescription& robot() const;
  std::size_t size() const;
  /// @brief Begins episodes, and observes. @throws InputError if there is no such element or scenario, or as Episode
  /// does; elements whose new episode cannot begin keep the present one
  void begin(const std::vector<EpisodeStart>& starts);
  /// @brief Walks the ticks of a step in all episodes, or up to their ends, and observes. Episodes that are over stay
  /// as they are. @param commands ahead, left [m/s] and rotation [rad/s] for each element
  /// @throws InputError if their number is wrong, one is not finite, or an episode has not begun; nothing has moved
  /// then
  void step(const std::vector<double>& commands);

  const RobotArrays& arrays() const;
  /// @brief Metrics of the robot of an episode so far. @throws InputError if there is no such episode
  RobotResult result(std::size_t element) const;
  /// @brief The agents of an episode. @throws InputError if there is no such episode
  void agents(std::size_t element, AgentArrays& arrays) const;
  /// @brief The walls of an episode, `map`. @throws InputError if there is no such episode
  std::vector<Wall> walls(std::size_t element) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crowd::library
