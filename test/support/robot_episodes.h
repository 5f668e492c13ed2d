#pragma once

#include <utility>

#include "simulation/episode.h"
#include "support/robots.h"

/// Episodes of robots for tests.
namespace crowd::robots {

/// An episode in which the first robot gets one command, after a number of ticks.
inline Episode after(int ticks, Scene scene, const Twist& command) {
  Episode episode(std::move(scene), 0, Vision());
  episode.robots().command(0, command);
  for (int tick = 0; tick < ticks; ++tick) episode.step({});
  return episode;
}

inline RobotResult resultAfter(int ticks, Scene scene, const Twist& command) {
  return after(ticks, std::move(scene), command).result().robots.at(0);
}

}  // namespace crowd::robots
