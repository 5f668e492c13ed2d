#include "robots/controllers/steering.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"

namespace crowd {
namespace {

constexpr double AHEAD = toRadians(30.0);    // a robot that can turn on the spot drives below this bearing [rad]
constexpr double TURN_RATE = 2.0;            // [1/s]
constexpr double LEAST_TURNING_SPEED = 0.2;  // of a robot that cannot

}  // namespace

Twist steer(Drive drive, double bearing, double speed) {
  if (drive == Drive::HOLONOMIC) return {speed * unitVector(bearing), 0.0};
  const double ahead = std::max(0.0, portable::cos(bearing));
  const bool turns_on_the_spot = drive != Drive::ACKERMANN;
  const double share =
      turns_on_the_spot ? (std::abs(bearing) < AHEAD ? ahead : 0.0) : std::max(LEAST_TURNING_SPEED, ahead);
  return {{speed * share, 0.0}, TURN_RATE * bearing};
}

}  // namespace crowd
