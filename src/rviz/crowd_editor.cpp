#include "rviz/crowd_editor.h"

#include <social_crowd/ChooseAgent.h>
#include <social_crowd/MoveObstacle.h>
#include <social_crowd/RemoveAgent.h>
#include <social_crowd/RemoveObstacle.h>
#include <social_crowd/RemoveRobot.h>
#include <social_crowd/SetGoal.h>
#include <social_crowd/Teleport.h>
#include <social_crowd/TeleportRobot.h>

#include <algorithm>

#include "ros/markers/marker_scene.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"
#include "ros/node/parameters.h"

namespace crowd {
namespace {

using Kind = EditorHandle::Kind;

constexpr bool HAS_THREAD = true;        // of the server of interactive markers
const ros::WallDuration ABANDONED(5.0);  // RViz reports a held marker more often
constexpr std::int64_t MAX_HANDLES = 10'000;

}  // namespace

EditorParameters readEditorParameters(const ros::NodeHandle& private_node) {
  Parameters parameters(private_node);
  EditorParameters read;
  read.controller = parameters.text("controller", read.controller);
  read.markers = parameters.text("markers", read.markers);
  read.rate = parameters.number("rate", read.rate, {0.1, 1e3, "Hz"});
  read.most_handles = static_cast<std::size_t>(
      parameters.whole("max_handles", static_cast<std::int64_t>(read.most_handles), 0, MAX_HANDLES));
  parameters.finish();
  return read;
}

CrowdEditor::CrowdEditor(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : parameters_(readEditorParameters(private_node)),
      node_(loop_.adopt(node)),
      states_(boost::make_shared<social_crowd::AgentStates>()),
      robots_(boost::make_shared<social_crowd::RobotStates>()),
      server_("crowd_editor", "", HAS_THREAD) {
  subscribers_ = {node_.subscribe<social_crowd::Scenario>(names::SCENARIO, SHORT_QUEUE,
                                                          [this](const auto& message) { takeScenario(*message); }),
                  node_.subscribe<social_crowd::AgentStates>(names::AGENTS, SHORT_QUEUE,
                                                             [this](const auto& message) { takeStates(message); }),
                  node_.subscribe<social_crowd::RobotStates>(names::ROBOTS, SHORT_QUEUE,
                                                             [this](const auto& message) { robots_ = message; }),
                  node_.subscribe<std_msgs::Int32>(names::CHOSEN_AGENT, SHORT_QUEUE,
                                                   [this](const auto& message) { chosen_agent_ = message->data; }),
                  node_.subscribe<geometry_msgs::PoseStamped>("chosen_agent/goal", SHORT_QUEUE,
                                                              [this](const auto& message) { takeGoal(*message); })};
  timer_ = node_.createWallTimer(ros::WallDuration(1.0 / parameters_.rate),
                                 [this](const ros::WallTimerEvent& /*event*/) { update(); });
}

void CrowdEditor::takeScenario(const social_crowd::Scenario& scenario) {
  if (scenario.robots.empty() && scenario.episode != robots_->episode) {  // without robots, no states are published
    robots_ = boost::make_shared<social_crowd::RobotStates>();
  }
  if (scenario.episode == states_->episode && !states_->agents.empty()) return;
  takeStates(statesAtStart(scenario));
}

void CrowdEditor::takeStates(const social_crowd::AgentStates::ConstPtr& states) {
  if (countMovable(*states) < countMovable(*states_)) ++removals_;
  states_ = states;
}

void CrowdEditor::run() {
  while (!loop_.isClosed()) loop_.run(IDLE);
}

void CrowdEditor::update() {
  const EditorHandles handles = handlesOf(*states_, *robots_, parameters_.most_handles, chosen_agent_, removals_);
  // Feedback to handles that are gone must not be taken for that to others of the same number.
  const bool has_lost =
      std::any_of(shown_.begin(), shown_.end(), [&](const auto& handle) { return handles.count(handle.first) == 0; });
  if (has_lost) show(handles);
  takeFeedback();
  show(handles);
}

void CrowdEditor::show(const EditorHandles& handles) {
  bool has_changed = false;
  for (const auto& [name, handle] : shown_) {
    if (handles.count(name) > 0) continue;
    server_.erase(name);
    has_changed = true;
  }
  for (const auto& [name, handle] : handles) {
    const auto old = shown_.find(name);
    if (old == shown_.end() || old->second.radius != handle.radius) {
      // The callback must not wait: the server is locked meanwhile.
      server_.insert(markerOf(name, handle), [this](const auto& feedback) {
        const std::lock_guard<std::mutex> lock(mutex_);
        feedback_.push_back(*feedback);
      });
      has_changed = true;
    } else if (!isHeld(name) && old->second.place != handle.place) {
      server_.setPose(name, poseOf(handle));
      has_changed = true;
    }
  }
  const EditorHandles before = std::move(shown_);
  shown_ = handles;
  for (const auto& [name, since] : held_) {  // moved when they are not held any more
    if (const auto old = before.find(name); old != before.end() && shown_.count(name) > 0)
      shown_[name].place = old->second.place;
  }
  if (has_changed) server_.applyChanges();
}

void CrowdEditor::takeFeedback() {
  std::vector<Feedback> feedback;
  std::vector<std::string> answered;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    feedback.swap(feedback_);
    answered.swap(answered_);
  }
  for (const Feedback& one : feedback) take(one);
  const auto release = [&](const std::string& name) {
    held_.erase(name);
    // Not where RViz has dropped it, but where the crowd has it.
    if (shown_.count(name) > 0) shown_[name].place = Vector2::Constant(NAN);
  };
  for (const std::string& name : answered) release(name);
  for (auto held = held_.begin(); held != held_.end();) {
    const auto [name, since] = *held++;
    if (ros::WallTime::now() - since > ABANDONED) release(name);
  }
}

void CrowdEditor::take(const Feedback& feedback) {
  const std::string& name = feedback.marker_name;
  if (shown_.count(name) == 0) return;
  switch (feedback.event_type) {
    case Feedback::MENU_SELECT:
      return choose(name, static_cast<EditorEntry>(feedback.menu_entry_id));
    case Feedback::MOUSE_UP:
      if (isHeld(name)) drop(name, fromPoint(feedback.pose.position));
      return;
    case Feedback::POSE_UPDATE:
    case Feedback::KEEP_ALIVE:
      held_[name] = ros::WallTime::now();
      return;
    default:
      return;
  }
}

template <typename Service>
void CrowdEditor::call(const std::string& node, const char* service, const typename Service::Request& request,
                       const std::string& handle) {
  line_.add<Service>(node_.resolveName(node) + "/" + service, request,
                     [this, handle](const typename Service::Response& response) {
                       if (response.success) {
                         ROS_INFO("%s", response.message.c_str());
                       } else {
                         ROS_WARN("%s", response.message.c_str());
                       }
                       const std::lock_guard<std::mutex> lock(mutex_);
                       answered_.push_back(handle);
                     });
}

void CrowdEditor::drop(const std::string& name, const Vector2& place) {
  const EditorHandle handle = shown_.at(name);
  if (handle.kind == Kind::AGENT) {
    social_crowd::Teleport::Request request;
    request.agent = handle.number;
    request.pose.x = place.x();
    request.pose.y = place.y();
    request.pose.theta = handle.heading;
    return call<social_crowd::Teleport>(parameters_.controller, names::TELEPORT, request, name);
  }
  if (handle.kind == Kind::ROBOT) {
    social_crowd::TeleportRobot::Request request;
    request.robot = handle.name;
    request.pose.x = place.x();
    request.pose.y = place.y();
    request.pose.theta = handle.heading;
    return call<social_crowd::TeleportRobot>(parameters_.controller, names::TELEPORT_ROBOT, request, name);
  }
  if (handle.kind == Kind::GOAL) {
    social_crowd::SetGoal::Request request;
    request.agent = handle.number;
    request.goal = toPoint(place);
    return call<social_crowd::SetGoal>(parameters_.controller, names::SET_GOAL, request, name);
  }
  social_crowd::MoveObstacle::Request request;
  request.obstacle = handle.number;
  request.position = toPoint(place);
  call<social_crowd::MoveObstacle>(parameters_.controller, names::MOVE_OBSTACLE, request, name);
}

void CrowdEditor::choose(const std::string& name, EditorEntry entry) {
  const EditorHandle handle = shown_.at(name);
  if (entry == EditorEntry::SHOW) {
    social_crowd::ChooseAgent::Request request;
    request.agent = static_cast<std::int32_t>(handle.number);
    return call<social_crowd::ChooseAgent>(parameters_.markers, names::CHOOSE_AGENT, request, name);
  }
  if (handle.kind == Kind::OBSTACLE) {
    social_crowd::RemoveObstacle::Request request;
    request.obstacle = handle.number;
    return call<social_crowd::RemoveObstacle>(parameters_.controller, names::REMOVE_OBSTACLE, request, name);
  }
  if (handle.kind == Kind::ROBOT) {
    social_crowd::RemoveRobot::Request request;
    request.robot = handle.name;
    return call<social_crowd::RemoveRobot>(parameters_.controller, names::REMOVE_ROBOT, request, name);
  }
  social_crowd::RemoveAgent::Request request;
  request.agent = handle.number;
  call<social_crowd::RemoveAgent>(parameters_.controller, names::REMOVE_AGENT, request, name);
}

void CrowdEditor::takeGoal(const geometry_msgs::PoseStamped& goal) {
  const bool is_in_map = goal.header.frame_id == names::MAP_FRAME || goal.header.frame_id.empty();
  if (chosen_agent_ < 0) ROS_WARN("no agent is chosen, so none gets the goal");
  if (!is_in_map) ROS_WARN("a goal is in the frame '%s', expected 'map'", goal.header.frame_id.c_str());
  if (chosen_agent_ < 0 || !is_in_map) return;
  social_crowd::SetGoal::Request request;
  request.agent = static_cast<std::uint32_t>(chosen_agent_);
  request.goal = goal.pose.position;
  call<social_crowd::SetGoal>(parameters_.controller, names::SET_GOAL, request, "");
}

}  // namespace crowd
