#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "maps/occupancy_map.h"
#include "scenario/population_spec.h"
#include "simulation/episode_monitor.h"
#include "world/world_editor.h"

namespace crowd {

class Episode;

/// @brief Changes the world of an episode, and its population, between two ticks. With way-finding it also refuses what
/// would make the floor too large, and an agent that cannot reach its goal then because of its own new place, goal or
/// route (WayLengths::requireWay()). The episode must outlive it.
class EpisodeEditor final : public WorldEditor {
 public:
  explicit EpisodeEditor(Episode& episode);

  /// @brief Lets a user send a robot to a goal [m], see Robots::send(). @throws InputError that says why the robot
  /// cannot be there, also for a goal off the map: beyond it, or on a cell that is not free; the robot keeps its goal
  void sendRobot(RobotId id, const Vector2& goal);
  /// @brief Adds a robot at a free place, as the last one. @throws InputError also if there is one of its name or
  /// namespace, or a goal is refused as by sendRobot()
  RobotId addRobot(const RobotStart& start);
  /// @brief Removes a robot, without a result; the ids of those after it become smaller by one. @throws InputError if
  /// agents follow it or one after it
  void removeRobot(RobotId id);
  /// @brief Replaces the map, and the walls that come from it. @param map_walls traced from the map [m]
  void replaceMap(std::shared_ptr<const OccupancyMap> map, const std::vector<Segment>& map_walls);
  /// @brief Replaces all agents, and what is known of their motion. @param agents, tracks by ascending id; on return
  /// the former ones
  void replaceCrowd(std::vector<Agent>& agents, std::vector<EpisodeMonitor::Track>& tracks);
  /// @brief Spawns an agent. Whether it stays when it has arrived is that of the scene (Scene::arrived), whatever its
  /// start says.
  AgentId addAgent(AgentStart start);
  /// @brief Lets an agent begin a route of the scenario.
  void setRoute(AgentId id, const std::string& route);
  /// @brief Opens or closes a gate of the scenario; one in which an agent stands closes later. @return whether it is
  /// open now
  bool setGate(const std::string& gate, bool open);
  /// @brief Lets people walk to a sink at once, or change their speed; a document of the scene has the alarm at its
  /// start. @param alarm its time is not used @return number of these people
  std::size_t raiseAlarm(AlarmDescription alarm);
  /// @brief Adds a source, which begins now. @param source as read from a scenario file @return its index
  std::size_t addSource(const SourceDescription& source);
  /// @brief Adds a gate. @throws InputError also if there is one of its name
  void addGate(const GateDescription& gate);

 private:
  void review(const WorldChange& change) override;
  void note(const WorldChange& change) override;
  /// Uses another population from now on.
  void adopt(PopulationDescription population);

  Episode& episode_;
};

}  // namespace crowd
