#pragma once

#include <cstddef>
#include <cstdint>

#include "common/text/number_limit.h"

/// @brief The greatest values that files, services and topics may give: far above those of any crowd, and so that
/// arithmetic stays exact, and memory and time bounded.
namespace crowd::limits {

/// Coordinates. Doubles are 1.2e-10 m apart there, less than TOUCH_TOLERANCE, to which bodies in a solid world do not
/// overlap.
constexpr NumberLimit PLACE{NumberRule::ANY, 1e6, "m"};
/// Distances between places, such as tolerances and radii of regions and of vision.
constexpr NumberLimit DISTANCE{NumberRule::POSITIVE, 1e6, "m"};
constexpr NumberLimit DISTANCE_OR_0{NumberRule::NOT_NEGATIVE, 1e6, "m"};
/// Radii of bodies, and places within a robot. All bodies within reach of the largest one are searched.
constexpr NumberLimit RADIUS{NumberRule::POSITIVE, 1e3, "m"};
constexpr NumberLimit OFFSET{NumberRule::ANY, 1e3, "m"};

/// Bodies that move farther in a tick meet more others in it.
constexpr NumberLimit SPEED{NumberRule::POSITIVE, 1e3, "m/s"};
constexpr NumberLimit SPEED_OR_0{NumberRule::NOT_NEGATIVE, 1e3, "m/s"};
constexpr NumberLimit VELOCITY{NumberRule::ANY, 1e3, "m/s"};  ///< components
constexpr NumberLimit PACE{NumberRule::POSITIVE, 10.0, ""};   ///< factors of speeds; `SPEED` limits the product, too
constexpr NumberLimit ROTATION{NumberRule::POSITIVE, 1e3, "rad/s"};
constexpr NumberLimit ACCELERATION{NumberRule::POSITIVE, 1e6, "m/s^2"};
constexpr NumberLimit ROTATION_ACCELERATION{NumberRule::POSITIVE, 1e6, "rad/s^2"};

/// Duration of a tick.
constexpr NumberLimit TICK{NumberRule::POSITIVE, 1e2, "s"};
constexpr double TICKS = 1e9;     ///< of an episode
constexpr double DURATION = 1e9;  ///< of an episode [s]; the clock of ROS ends at 4e9 s

/// Agents of a source that are due per second: with TICK, 100,000 in a tick.
constexpr NumberLimit RATE{NumberRule::POSITIVE, 1e3, "agents/s"};
/// Agents, or obstacles, of an entry of a scenario.
constexpr std::int64_t COUNT = 1'000'000;
/// Agents, or obstacles, of a scenario, and agents on their way at the same time: some GB.
constexpr std::size_t BODIES = 10'000'000;
/// Each has sensors of its own.
constexpr std::size_t ROBOTS = 1000;
constexpr std::int64_t RAYS = 100'000;  ///< of a laser scanner
constexpr std::int64_t RINGS = 256;     ///< of a laser scanner
/// Relative errors, and errors in radians per metre, of a robot's odometry.
constexpr NumberLimit ODOMETRY_ERROR{NumberRule::NOT_NEGATIVE, 10.0, ""};
/// False detections of a tracker per second: with TICK, 100,000 in a tick.
constexpr NumberLimit FALSE_DETECTIONS{NumberRule::NOT_NEGATIVE, 1e3, "per second"};
/// Time for which a tracker keeps a track: that of the longest episode.
constexpr NumberLimit KEEP{NumberRule::NOT_NEGATIVE, DURATION, "s"};

/// Positions of the recorded people of a scenario: some 100 MB.
constexpr std::size_t SAMPLES = 10'000'000;
constexpr NumberLimit FRAME_RATE{NumberRule::POSITIVE, 1e6, "Hz"};  ///< of a recording

/// Cells of a map; also samples of its image, which has up to four for each pixel: 100 MB.
constexpr std::uint64_t CELLS = 100'000'000;

/// Values of a Q-table, its rows times its actions: 1.2 GB.
constexpr std::uint64_t Q_VALUES = 100'000'000;

/// Neighbours that an agent perceives if their number is limited: memory for this many of each agent is taken.
constexpr std::uint32_t NEIGHBOURS = 1000;

}  // namespace crowd::limits
