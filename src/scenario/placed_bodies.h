#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/stop_request.h"
#include "geometry/disc_buckets.h"
#include "geometry/footprint.h"

namespace crowd {

/// @brief Maximum number of draws of a body before the scenario is rejected.
constexpr int MAX_TRIES = 1000;

/// @brief Name of a body in messages: its entry in the file, and its number among the bodies of that entry.
struct Label {
  const char* list;
  std::size_t entry;
  int line;
  int number;
  int count;
  std::optional<std::uint64_t> person = std::nullopt;  ///< of a recording

  std::string text() const {
    const std::string name = std::string(list) + "[" + std::to_string(entry) + "]";
    if (person) return name + " (person " + std::to_string(*person) + ")";
    return count == 1 ? name : name + " (" + std::to_string(number) + " of " + std::to_string(count) + ")";
  }
};

/// @brief Calls work(group, label, index) for each body of these groups; `index` counts the bodies.
template <typename Groups, typename Work>
void forEachBody(const char* list, const Groups& groups, const StopRequest& stop, const Work& work) {
  std::size_t index = 0;
  for (std::size_t entry = 0; entry < groups.size(); ++entry) {
    const auto& group = groups[entry];
    for (int number = 1; number <= group.count; ++number, ++index) {
      stop.throwIfMade();
      work(group, Label{list, entry, group.line, number, group.count}, index);
    }
  }
}

/// @brief A body or wall that overlaps a requested position, and the depth of the overlap [m].
struct Blocker {
  std::string name;
  double depth;
};

/// @brief Bodies and goals of a scene whose positions are determined, and its walls.
class PlacedBodies {
 public:
  explicit PlacedBodies(const std::vector<Segment>& walls) : walls_(walls) {}

  /// @brief Adds a disc [m]. @param at_rest whether it is static during the whole episode
  void add(const Label& label, const Vector2& centre, double radius, bool at_rest) {
    bodies_.push_back({label, at_rest, false});
    discs_.add(centre, radius);
  }
  /// @brief Adds a robot. @param radius of the smallest disc about its position that contains it [m]
  void addRobot(const Label& label, const Vector2& centre, double radius) {
    bodies_.push_back({label, false, true});
    discs_.add(centre, radius);
  }
  /// @brief Adds a goal [m]. @param radius of its agent [m]
  void addGoal(const Vector2& point, double radius) { goals_.add(point, radius); }

  /// @brief Finds a body or wall that is less than `gap` [m] away from a disc.
  std::optional<Blocker> findBlocker(const Vector2& centre, double radius, double gap) const;
  /// @brief Finds a body, other than a robot, or a wall that overlaps a footprint. The depth of an overlap of a polygon
  /// and a wall is 0.
  std::optional<Blocker> findBlocker(const Footprint& footprint, const Pose& pose) const;
  /// @brief Whether a disc overlaps an agent that stands at its goal.
  bool isNearGoal(const Vector2& centre, double radius) const;
  /// @brief Whether no wall separates two places [m].
  bool canWalkBetween(const Vector2& from, const Vector2& to) const;
  /// @brief Whether a disc overlaps neither walls nor bodies at rest.
  bool canStandAt(const Vector2& point, double radius) const;

 private:
  struct Body {
    Label label;
    bool at_rest;
    bool is_robot;
  };

  const std::vector<Segment>& walls_;
  std::vector<Body> bodies_;
  DiscBuckets discs_;  // of the bodies
  DiscBuckets goals_;
};

}  // namespace crowd
