#include "ros/markers/marker_scene.h"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <utility>

#include "learning/model.h"
#include "ros/markers/marker_drawings.h"
#include "ros/markers/marker_groups.h"
#include "ros/markers/marker_map.h"
#include "ros/messages/conversions.h"

namespace crowd {
namespace {

using social_crowd::AgentState;
using social_crowd::AgentStates;
using social_crowd::RobotState;
using social_crowd::RobotStates;
using visualization_msgs::Marker;

/// Copies a part of a list; nothing if it lies beyond the list, so that requireValid() finds the copy invalid.
template <typename List>
void copyPart(const List& list, std::uint32_t first, std::uint32_t count, List& copy) {
  if (std::uint64_t{first} + count > list.size()) return;
  for (std::uint32_t i = first; i < first + count; ++i) copy.push_back(list[i]);
}

/// Returns the perceptions of one agent; empty if it is not among them.
Perceptions only(std::int64_t agent, const Perceptions& perceptions) {
  Perceptions own;
  own.episode = perceptions.episode;
  own.tick = perceptions.tick;
  own.tick_duration = perceptions.tick_duration;
  for (const AgentPerception& self : perceptions.agents) {
    if (self.agent != agent) continue;
    copyPart(perceptions.neighbours, self.first_neighbour, self.neighbour_count, own.neighbours);
    copyPart(perceptions.walls, self.first_wall, self.wall_count, own.walls);
    own.agents.push_back(self);
    own.agents.back().first_neighbour = own.agents.back().first_wall = 0;
    break;
  }
  return own;
}

void drawPaths(WalkedPaths& paths, Walkers walkers, bool whole, visualization_msgs::MarkerArray& array) {
  if (whole || paths.isUnsettled()) {
    paths.settle();
    array.markers.push_back(drawSettledPaths(paths, walkers));
  }
  array.markers.push_back(drawRecentPaths(paths, walkers));
}

}  // namespace

Eigen::AlignedBox2d boundsOf(const social_crowd::Scenario& scenario) {
  Eigen::AlignedBox2d area;
  const auto add = [&](double x, double y) {
    if (std::isfinite(x) && std::isfinite(y)) area.extend(Vector2(x, y));
  };
  for (const AgentState& agent : scenario.agents) {
    add(agent.pose.x, agent.pose.y);
    add(agent.goal.x, agent.goal.y);
  }
  for (const social_crowd::ObstacleState& obstacle : scenario.obstacles) add(obstacle.position.x, obstacle.position.y);
  for (const social_crowd::Wall& wall : scenario.walls) {
    add(wall.from.x, wall.from.y);
    add(wall.to.x, wall.to.y);
  }
  return area;
}

Vector2 middleOf(const social_crowd::Scenario& scenario) {
  const Eigen::AlignedBox2d area = boundsOf(scenario);
  return area.isEmpty() ? Vector2(Vector2::Zero()) : Vector2(area.center());
}

void KnownStateSets::take(const social_crowd::LearnerStatus& status) {
  if (state_set_ == nullptr || status.model != model_) {
    state_set_ = parseModel(status.model).state_set;
    model_ = status.model;
  }
  if (status.serves_all != 0) for_all_ = state_set_;
  for (const AgentId agent : status.agents) own_[agent] = state_set_;
}

const StateSet* KnownStateSets::of(AgentId agent) const {
  const auto own = own_.find(agent);
  return own == own_.end() ? for_all_.get() : own->second.get();
}

social_crowd::AgentStates::ConstPtr statesAtStart(const social_crowd::Scenario& scenario) {
  const auto states = boost::make_shared<social_crowd::AgentStates>();
  states->episode = scenario.episode;
  states->tick = scenario.tick;
  states->agents = scenario.agents;
  states->obstacles = scenario.obstacles;
  return states;
}

MarkerScene::MarkerScene(const MarkerOptions& options)
    : options_(options),
      states_(boost::make_shared<AgentStates>()),
      map_(drawMap({})),
      paths_(options.path_step, options.path_points),
      robots_(boost::make_shared<RobotStates>()),
      robot_paths_(options.path_step, options.path_points) {}

void MarkerScene::take(const AgentStates::ConstPtr& message) { show(message); }

void MarkerScene::take(const RobotStates::ConstPtr& message) {
  if (message->episode != robots_->episode || message->tick < robots_->tick) robot_paths_.clear();
  robot_paths_.setTimes(states_->time, pathTime(message->robots.size()));
  for (const RobotState& robot : message->robots) {
    if (hasPlace(robot)) robot_paths_.add(robot.robot, {robot.pose.x, robot.pose.y});
  }
  robots_ = message;
  changed_ = true;
}

void MarkerScene::take(const social_crowd::Scenario& message) {
  walls_ = message.walls;
  changed_ = true;
  if (message.episode != robots_->episode && !robots_->robots.empty()) {  // there may be none in this one
    robots_ = boost::make_shared<RobotStates>();
    robot_paths_.clear();
  }
  if (message.episode != states_->episode || states_->agents.empty()) show(statesAtStart(message));
}

void MarkerScene::take(const social_crowd::Walls& message) {
  walls_ = message.walls;
  changed_ = true;
}

void MarkerScene::take(const nav_msgs::OccupancyGrid& message) {
  map_ = drawMap(message.data.empty() ? OccupancyMap() : fromMessage(message));
  map_changed_ = changed_ = true;
}

bool MarkerScene::showsFigures() const {
  if (options_.figures != MarkerOptions::Figures::AUTO) return options_.figures == MarkerOptions::Figures::PEOPLE;
  return countWalkers() <= MarkerOptions::MOST_FIGURES;
}

std::size_t MarkerScene::countWalkers() const {
  return static_cast<std::size_t>(std::count_if(states_->agents.begin(), states_->agents.end(), isOnFloor));
}

double MarkerScene::pathTime(std::size_t walkers) const {
  return options_.path_time > 0.0 ? options_.path_time : pathTimeFor(walkers);
}

void MarkerScene::show(const AgentStates::ConstPtr& states) {
  // A bag that is played repeatedly may begin with the episode with which it ends.
  if (states->episode != states_->episode || states->tick < states_->tick) {
    if (decision_ != nullptr && decision_->tick > states->tick) decision_.reset();
    paths_.clear();
    figures_.clear();
    recorded_.clear();
    most_walkers_ = 0;
  }
  states_ = states;
  most_walkers_ = std::max(most_walkers_, countWalkers());
  paths_.setTimes(states->time, pathTime(most_walkers_));
  for (const AgentState& agent : states->agents) {
    if (hasPlace(agent)) paths_.add(agent.agent, {agent.pose.x, agent.pose.y});
  }
  figures_.take(*states);
  recorded_.take(*states);
  changed_ = true;
}

void MarkerScene::choose(std::int64_t agent) {
  options_.agent = agent;
  perceptions_ = Perceptions();
  decision_.reset();
  changed_ = true;
}

void MarkerScene::take(const social_crowd::DecisionValues::ConstPtr& message) {
  if (message->agent != options_.agent) return;
  decision_ = message;
  changed_ = true;
}

void MarkerScene::take(const PerceptionsMessage& message) {
  const Perceptions& content = message.content();
  Perceptions own = only(options_.agent, content);
  // In a sequential tick each agent has its own turn: keep the perception of the chosen agent.
  const bool is_next =
      content.episode == perceptions_.episode && content.tick <= perceptions_.tick + 1 && !content.last;
  if (own.agents.empty() && is_next) return;
  perceptions_ = Perceptions();
  changed_ = true;
  requireValid(own);
  perceptions_ = std::move(own);
}

void MarkerScene::take(const social_crowd::LearnerStatus& message) {
  state_sets_.take(message);
  changed_ = true;
}

const AgentState* MarkerScene::findChosen() const {
  for (const AgentState& agent : states_->agents) {
    if (agent.agent == options_.agent) return &agent;
  }
  return nullptr;
}

Marker MarkerScene::drawRadii() const {
  const bool all = options_.radii == MarkerOptions::Radii::ALL;
  RadiiDrawing drawing(all ? states_->agents.size() : 1);
  if (options_.radii == MarkerOptions::Radii::NONE) return drawing.finish();
  for (const AgentState& agent : states_->agents) {
    const bool chosen = agent.agent == options_.agent;
    if (!all && !chosen) continue;
    const StateSet* const state_set = state_sets_.of(agent.agent);
    if (state_set == nullptr) continue;
    const auto* const picture = dynamic_cast<const SectorPicture*>(state_set);
    drawing.add(agent, picture != nullptr ? picture->distanceLimits() : std::vector<double>{state_set->visionRadius()},
                !chosen);
  }
  return drawing.finish();
}

Marker MarkerScene::drawOccupiedSectors() const {
  const AgentState* const chosen = findChosen();
  const auto* const picture =
      chosen == nullptr ? nullptr : dynamic_cast<const SectorPicture*>(state_sets_.of(chosen->agent));
  if (picture == nullptr || !isOnFloor(*chosen) || perceptions_.agents.empty() ||
      perceptions_.episode != states_->episode) {
    return drawSectors({}, {}, {});
  }
  const Perception perception(perceptions_, 0);
  return drawSectors(perception.self.pose, picture->occupiedSectors(perception), picture->distanceLimits());
}

void MarkerScene::drawValues(visualization_msgs::MarkerArray& array) {
  const AgentState* const chosen = findChosen();
  const bool shown =
      chosen != nullptr && isOnFloor(*chosen) && decision_ != nullptr && decision_->episode == states_->episode;
  values_.draw(shown ? decision_.get() : nullptr, shown ? chosen->radius : 0.0, array);
}

visualization_msgs::MarkerArray MarkerScene::draw(bool whole) {
  visualization_msgs::MarkerArray array;
  const bool figures = showsFigures();
  array.markers = {
      drawBodies(*states_, figures), drawContacts(*states_), drawHeadings(*states_, figures), drawGoals(*states_),
      drawGroups(*states_),          drawWalls(walls_),      drawObstacles(*states_),         drawRadii(),
      drawOccupiedSectors()};
  if (whole || map_changed_) array.markers.push_back(map_);
  drawValues(array);
  figures_.draw(*states_, figures, whole, array);
  recorded_.draw(figures, whole, array);
  drawPaths(paths_, Walkers::AGENTS, whole, array);
  if (!robots_->robots.empty() || robot_paths_.isUnsettled()) {
    for (const auto& draw : {drawRobots, drawRobotHeadings, drawRobotContacts, drawRobotGoals}) {
      array.markers.push_back(draw(*robots_));
    }
    drawPaths(robot_paths_, Walkers::ROBOTS, whole, array);
  }
  changed_ = map_changed_ = false;
  return array;
}

}  // namespace crowd
