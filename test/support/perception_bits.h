#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "world/perception.h"

namespace crowd {

/// The bits of numbers, for exact comparison.
using Bits = std::vector<std::uint64_t>;

inline Bits bitsOf(const std::vector<double>& numbers) {
  Bits bits(numbers.size());
  std::memcpy(bits.data(), numbers.data(), numbers.size() * sizeof(double));
  return bits;
}

/// All fields of a perception except the positions in the lists.
inline Bits bitsOf(const Perception& seen) {
  const AgentPerception& self = seen.self;
  std::vector<double> numbers = {self.pose.position.x(),
                                 self.pose.position.y(),
                                 self.pose.heading,
                                 self.velocity.x(),
                                 self.velocity.y(),
                                 self.max_speed,
                                 self.radius,
                                 self.goal.x(),
                                 self.goal.y(),
                                 seen.tick_duration,
                                 self.arrived ? 1.0 : 0,
                                 self.acted ? 1.0 : 0.0,
                                 double(self.goal_number)};
  for (const Neighbour& neighbour : seen.neighbours) {
    numbers.insert(numbers.end(), {neighbour.position.x(), neighbour.position.y(), neighbour.velocity.x(),
                                   neighbour.velocity.y(), neighbour.radius, static_cast<double>(neighbour.kind)});
  }
  numbers.push_back(static_cast<double>(seen.walls.size()));
  for (const Segment& wall : seen.walls) {
    numbers.insert(numbers.end(), {wall.from.x(), wall.from.y(), wall.to.x(), wall.to.y()});
  }
  return bitsOf(numbers);
}

}  // namespace crowd
