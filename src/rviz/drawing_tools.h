#pragma once

#include "rviz/floor_tool.h"

namespace crowd {

/// @brief Tool `social_crowd/AddAgent`: press where the agent is to stand, release at its goal.
class AddAgentTool : public FloorTool {
 public:
  AddAgentTool();

 private:
  FloorOutline outline(const Vector2& from, const Vector2& to) const override;
  void finish(const Vector2& from, const Vector2& to) override;

  rviz::FloatProperty* max_speed_;  // [m/s]
  rviz::FloatProperty* radius_;     // [m]
};

/// @brief Tool `social_crowd/AddObstacle`: press at its centre, release at its rim; a click takes the property
/// `Radius`.
class AddObstacleTool : public FloorTool {
 public:
  AddObstacleTool();

 private:
  FloorOutline outline(const Vector2& from, const Vector2& to) const override;
  void finish(const Vector2& from, const Vector2& to) override;
  double radiusOf(const Vector2& from, const Vector2& to) const;

  rviz::FloatProperty* radius_;  // [m]
};

/// @brief Tool `social_crowd/DrawWall`: press at one end, release at the other.
class DrawWallTool : public FloorTool {
 public:
  DrawWallTool();

 private:
  FloorOutline outline(const Vector2& from, const Vector2& to) const override;
  void finish(const Vector2& from, const Vector2& to) override;
};

}  // namespace crowd
