#include "ros/markers/crowd_markers.h"

#include <geometry_msgs/TransformStamped.h>
#include <social_crowd/ChooseAgent.h>
#include <std_msgs/Int32.h>
#include <visualization_msgs/MarkerArray.h>

#include "common/text/quotes.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/publish_latched.h"
#include "ros/messages/topic_defaults.h"
#include "ros/node/parameters.h"

namespace crowd {
namespace {

constexpr std::uint32_t MARKERS_QUEUE = 2;       // messages; only the newest is used
constexpr double SHOWING_WARNING_PERIOD = 10.0;  // [s]
const ros::WallDuration REPEAT_AFTER(1.0);

constexpr NumberRange RATE{0.1, 1e3, "Hz"};
constexpr NumberRange PATH_STEP{0.0, 1e3, "m"};
constexpr NumberRange PATH_TIME{0.0, 1e9, "s"};
constexpr std::int64_t MAX_PATH_POINTS = 10'000'000;

MarkerOptions::Radii readRadii(Parameters& parameters) {
  const std::string text = parameters.text("radii", "chosen", "none, chosen or all");
  if (text == "none") return MarkerOptions::Radii::NONE;
  if (text == "all") return MarkerOptions::Radii::ALL;
  if (text != "chosen") parameters.complain("radii", "expected none, chosen or all, got " + inQuotes(text));
  return MarkerOptions::Radii::CHOSEN;
}

MarkerOptions::Figures readFigures(Parameters& parameters) {
  const std::string text = parameters.text("figures", "auto", "auto, discs or people");
  if (text == "discs") return MarkerOptions::Figures::DISCS;
  if (text == "people") return MarkerOptions::Figures::PEOPLE;
  if (text != "auto") parameters.complain("figures", "expected auto, discs or people, got " + inQuotes(text));
  return MarkerOptions::Figures::AUTO;
}

}  // namespace

MarkerParameters readMarkerParameters(const ros::NodeHandle& private_node) {
  Parameters parameters(private_node);
  MarkerParameters read;
  MarkerOptions& options = read.options;
  read.rate = parameters.number("rate", read.rate, RATE);
  options.agent = parameters.whole("agent", options.agent, MarkerOptions::NO_AGENT, INT32_MAX);
  read.values = parameters.flag("values", read.values);
  options.radii = readRadii(parameters);
  options.figures = readFigures(parameters);
  options.path_time = parameters.number("path_time", options.path_time, PATH_TIME);
  options.path_step = parameters.number("path_step", options.path_step, PATH_STEP);
  options.path_points = static_cast<std::size_t>(
      parameters.whole("path_points", static_cast<std::int64_t>(options.path_points), 1, MAX_PATH_POINTS));
  parameters.finish();
  return read;
}

CrowdMarkers::CrowdMarkers(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : CrowdMarkers(node, private_node, readMarkerParameters(private_node)) {}

CrowdMarkers::CrowdMarkers(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           const MarkerParameters& parameters)
    : node_(loop_.adopt(node)),
      shows_values_(parameters.values),
      scene_(parameters.options),
      chosen_(node_.advertise<std_msgs::Int32>(names::CHOSEN_AGENT, QUEUE, LATCHED)),
      services_(private_node, 1) {
  choose(parameters.options.agent);
  publisher_ = node_.advertise<visualization_msgs::MarkerArray>("markers", MARKERS_QUEUE);
  agents_ = node_.subscribe<social_crowd::AgentStates>(names::AGENTS, QUEUE,
                                                       [this](const auto& message) { scene_.take(message); });
  publishFrame(Vector2::Zero());
  scenario_ = node_.subscribe<social_crowd::Scenario>(names::SCENARIO, QUEUE,
                                                      [this](const auto& message) { takeScenario(*message); });
  walls_ =
      node_.subscribe<social_crowd::Walls>(names::WALLS, QUEUE, [this](const auto& message) { scene_.take(*message); });
  robots_ = node_.subscribe<social_crowd::RobotStates>(names::ROBOTS, QUEUE,
                                                       [this](const auto& message) { scene_.take(message); });
  map_ = subscribe<nav_msgs::OccupancyGrid>(names::MAP);
  learner_status_ = subscribe<social_crowd::LearnerStatus>(names::LEARNER_STATUS);
  timer_ = node_.createWallTimer(ros::WallDuration(1.0 / parameters.rate),
                                 [this](const ros::WallTimerEvent& /*event*/) { publish(); });
  services_.serve<social_crowd::ChooseAgent>(names::CHOOSE_AGENT, [this](const auto& request, auto& response) {
    if (request.agent < MarkerOptions::NO_AGENT) {
      throw InputError("agent: expected a number, or -1 for none, got " + std::to_string(request.agent));
    }
    loop_.ask<void>([&] { choose(request.agent); });
    response.message = request.agent < 0 ? "no agent is shown" : "agent " + std::to_string(request.agent) + " is shown";
  });
}

void CrowdMarkers::run() {
  services_.start();
  while (!loop_.isClosed()) loop_.run(IDLE);
  loop_.close();
  services_.stop();
}

void CrowdMarkers::choose(std::int64_t agent) {
  has_chosen_ = agent != MarkerOptions::NO_AGENT;
  scene_.choose(agent);
  std_msgs::Int32 message;
  message.data = static_cast<std::int32_t>(agent);
  publishLatched(chosen_, message);
}

void CrowdMarkers::takeScenario(const social_crowd::Scenario& message) {
  scene_.take(message);
  // The view must not jump at each episode of the same scenario.
  if (message.name == scenario_name_ && !scenario_name_.empty()) return;
  scenario_name_ = message.name;
  publishFrame(middleOf(message).array().round());  // the lines of RViz's grid are at whole metres
}

void CrowdMarkers::publishFrame(const Vector2& middle) {
  geometry_msgs::TransformStamped frame;
  frame.header.frame_id = names::MAP_FRAME;
  frame.child_frame_id = names::CROWD_FRAME;
  frame.transform.translation = toVector3(middle);
  frame.transform.rotation = toQuaternion(0.0);
  frame_broadcaster_.sendTransform(frame);
}

template <typename Message>
ros::Subscriber CrowdMarkers::subscribe(const char* topic) {
  return node_.subscribe<Message>(topic, QUEUE, [this, topic](const typename Message::ConstPtr& message) {
    try {
      scene_.take(*message);
    } catch (const Error& error) {
      ROS_WARN_THROTTLE(SHOWING_WARNING_PERIOD, "cannot show a message on %s: %s", topic, error.what());
    }
  });
}

void CrowdMarkers::subscribeToPerceptions(bool wanted) {
  if (wanted == static_cast<bool>(perceptions_)) return;
  perceptions_ = wanted ? subscribe<PerceptionsMessage>(names::PERCEPTIONS) : ros::Subscriber();
}

void CrowdMarkers::subscribeToValues(bool wanted) {
  if (wanted == static_cast<bool>(values_)) return;
  values_ = ros::Subscriber();
  if (!wanted) return;
  values_ = node_.subscribe<social_crowd::DecisionValues>(names::DECISION_VALUES, QUEUE,
                                                          [this](const auto& message) { scene_.take(message); });
}

void CrowdMarkers::publish() {
  const std::uint32_t listeners = publisher_.getNumSubscribers();
  const bool newcomers = listeners > listeners_;
  listeners_ = listeners;
  subscribeToPerceptions(listeners > 0 && has_chosen_);
  subscribeToValues(listeners > 0 && has_chosen_ && shows_values_);
  if (listeners == 0) return;
  const ros::WallTime now = ros::WallTime::now();
  const bool whole = newcomers || now - last_whole_ >= REPEAT_AFTER || now < last_whole_;
  if (!whole && !scene_.hasChanged()) return;
  publisher_.publish(scene_.draw(whole));
  if (whole) last_whole_ = now;
}

}  // namespace crowd
