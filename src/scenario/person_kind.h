#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/random.h"
#include "scenario/figure.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief A number drawn uniformly from a range, or, with a deviation, normally and within the range.
struct Distribution {
  struct Normal {
    double mean = 0.0;  ///< within the range
    double deviation = 0.0;
  };
  Range range;
  std::optional<Normal> normal;

  double draw(KeyedRandom& random) const;
};

/// @brief How people slow down or stop by themselves, for example to read a message.
struct PauseDescription {
  double every = 0.0;  ///< mean time from the end of a pause to the next one [s]
  Range duration;      ///< [s]
  double speed = 0.0;  ///< during a pause, as a share of the maximum speed; 0: they stand
};

/// @brief One entry under `kinds`: people who are alike.
struct PersonKind {
  std::string name;
  std::string source;  ///< file, and document if it has several, for messages
  int line = 0;        ///< in the file, for messages
  Distribution speed;  ///< maximum speed [m/s]
  Range radius;        ///< [m]
  Figure figure = Figure::ADULT;
  std::optional<PauseDescription> pauses;
};

/// @brief Draws the kind of one agent of an entry, and those of its speed and radius that the entry does not give.
/// Does nothing if the entry has no kinds.
/// @param kinds of the population @param random of this agent
void drawKind(const AgentGroup& group, const std::vector<PersonKind>& kinds, KeyedRandom random, AgentStart& start);

/// @brief Draws how one agent of an entry reacts to robots. @param random of this agent
void drawReaction(const AgentGroup& group, KeyedRandom random, AgentStart& start);

}  // namespace crowd
