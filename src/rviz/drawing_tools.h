#pragma once

#include <rviz/properties/bool_property.h>

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

/// @brief Tool `social_crowd/AddRobot`: press where the robot is to stand, release at its goal; after a click it has no
/// goal.
class AddRobotTool : public FloorTool {
 public:
  AddRobotTool();

 private:
  FloorOutline outline(const Vector2& from, const Vector2& to) const override;
  void finish(const Vector2& from, const Vector2& to) override;

  rviz::FloatProperty* max_speed_;  // [m/s]
  rviz::FloatProperty* radius_;     // [m]
};

/// @brief Tool `social_crowd/AddSource`: press where its agents are to appear, release at their goal.
class AddSourceTool : public FloorTool {
 public:
  AddSourceTool();

 private:
  FloorOutline outline(const Vector2& from, const Vector2& to) const override;
  void finish(const Vector2& from, const Vector2& to) override;

  rviz::FloatProperty* rate_;       // [1/s]
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

/// @brief Tool `social_crowd/AddGate`: press at one end, release at the other.
class AddGateTool : public FloorTool {
 public:
  AddGateTool();

 private:
  FloorOutline outline(const Vector2& from, const Vector2& to) const override;
  void finish(const Vector2& from, const Vector2& to) override;

  rviz::BoolProperty* open_;
};

}  // namespace crowd
