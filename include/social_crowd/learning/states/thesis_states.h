#pragma once

#include <cstddef>
#include <vector>

#include "social_crowd/learning/states/distance_classes.h"
#include "social_crowd/learning/states/obstacle_classes.h"
#include "social_crowd/learning/states/state_set.h"

namespace crowd {

/// @brief What the state sets of the thesis have in common: one row per perception, two distance classes, and a last
/// row for an agent that has arrived.
class ThesisStates : public StateSet, public RowDistanceClasses, public SectorPicture {
 public:
  explicit ThesisStates(const DistanceClasses& distances) : distances_(distances) {}

  Row rowCount() const override { return terminal() + 1; }
  double visionRadius() const override { return distances_.vision_radius; }
  std::vector<double> distanceLimits() const override {
    return {distances_.collision_radius, distances_.vision_radius};
  }
  /// @brief The row of an agent that has arrived, the last one; see StateSet::rowCount().
  virtual Row terminal() const = 0;

 protected:
  const DistanceClasses& distances() const { return distances_; }
  /// Returns the distance classes as YAML, to be the last keys of spec().
  std::string distancesSpec() const;

 private:
  DistanceClasses distances_;
};

/// @brief Reads the keys collision_radius and vision_radius, both optional. @throws InputError
DistanceClasses readDistanceClasses(const YamlMap& map);

}  // namespace crowd
