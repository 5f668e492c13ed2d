#pragma once

#include <string>
#include <vector>

#include "learning/states/distance_classes.h"
#include "learning/states/obstacle_sectors.h"

namespace crowd {

/// @brief A quantity that the rows of a state set encode, with the names of its classes.
struct RowQuantity {
  std::string name;
  std::vector<std::string> classes;
};

/// @brief What the rows of a state set mean.
struct RowMeaning {
  std::vector<RowQuantity> quantities;
  /// Numbers of the classes of each row but a terminal one. Empty: the rows are all combinations, and the first
  /// quantity changes slowest.
  std::vector<std::vector<int>> rows;
  bool has_terminal = false;  ///< the last row is that of an agent that has arrived

  /// @brief A YAML map {quantities: [{name, classes}], rows, extra: names of further rows}.
  std::string text() const;
};

/// @brief Implemented by state sets whose rows can be explained and drawn (scripts/draw_q_table).
class ExplainedRows {
 public:
  virtual ~ExplainedRows() = default;
  virtual RowMeaning meaning() const = 0;
};

/// @brief A number with at most six digits, for names of classes.
std::string shortText(double number);
/// @brief Names of sectors: directions if there are eight, else the angles of their middles.
std::vector<std::string> namesOf(const EvenSectors& sectors);
/// @brief Names of sectors: side and limits, such as "left 0-15°".
std::vector<std::string> namesOf(const MirroredSectors& sectors);
std::vector<std::string> namesOf(const ObstacleSectors& sectors);
/// @brief Names of the distance classes 1, 2: "up to 0.5 m".
std::vector<std::string> namesOf(const DistanceClasses& distances);
/// @brief Names of the classes between limits, such as "< 1 s", "1-2 s", "≥ 2 s". @param unit with a blank before it,
/// if one belongs there
std::vector<std::string> classNames(const std::vector<double>& limits, const std::string& unit);

}  // namespace crowd
