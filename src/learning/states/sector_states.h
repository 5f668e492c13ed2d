#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "learning/states/distance_classes.h"
#include "learning/states/obstacle_classes.h"
#include "learning/states/state_set.h"

namespace crowd {

/// @brief Base of state sets that divide the surroundings into sectors, as those of the thesis: one row per perception,
/// two distance classes, and a terminal row. They can be combined with the reward of the thesis and drawn.
class SectorStates : public StateSet, public RowDistanceClasses, public SectorPicture {
 public:
  explicit SectorStates(const DistanceClasses& distances) : distances_(distances) {}

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

/// @brief Returns limits of sectors [degrees] as the key and value that readSectorLimits() reads.
std::string sectorLimitsSpec(const std::vector<double>& degrees);

/// @brief Reads the optional key obstacle_sectors, the outer limits of sectors on each side [degrees].
/// @throws InputError
std::vector<double> readSectorLimits(const YamlMap& map, const std::vector<double>& otherwise);

/// @brief Reads the keys collision_radius and vision_radius, both optional. @throws InputError
DistanceClasses readDistanceClasses(const YamlMap& map);

}  // namespace crowd
