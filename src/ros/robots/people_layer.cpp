#include "ros/robots/people_layer.h"

#include <costmap_2d/cost_values.h>
#include <tf2/exceptions.h>
#include <pluginlib/class_list_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "common/text/numbers.h"
#include "ros/messages/agent_status.h"
#include "ros/messages/names.h"
#include "ros/robots/robot_messages.h"

namespace crowd {
namespace {

constexpr double WARN_PERIOD = 10.0;  // [s]
// The largest cost of a cell in which the centre of a robot may be.
constexpr double MAX_COST = costmap_2d::INSCRIBED_INFLATED_OBSTACLE - 1;
constexpr double UNLIMITED = std::numeric_limits<double>::infinity();
#ifdef SOCIAL_CROWD_PEOPLE_MSGS
constexpr const char* USUAL_SOURCE = names::PEOPLE;
#else
constexpr const char* USUAL_SOURCE = names::AGENTS;
#endif

template <typename Vector>
Vector2 toVector(const Vector& vector) {
  return {vector.x, vector.y};
}

void extend(Bounds& bounds, const Bounds& by) {
  bounds.low = bounds.low.cwiseMin(by.low);
  bounds.high = bounds.high.cwiseMax(by.high);
}

}  // namespace

void PeopleLayer::onInitialize() {
  current_ = true;
  enabled_ = true;
  parameters_ = ros::NodeHandle("~/" + name_);
  readParameters();
  auto source = parameters_.param<std::string>("source", USUAL_SOURCE);
  if (source != USUAL_SOURCE && source != names::AGENTS) {
    ROS_ERROR("%s/source: expected %s, got '%s', which is not used", parameters_.getNamespace().c_str(),
              USUAL_SOURCE == std::string(names::AGENTS) ? "agents (the package was built without people_msgs)"
                                                         : "people or agents",
              source.c_str());
    source = USUAL_SOURCE;
  }
  subscribe(source, parameters_.param<std::string>("topic", source));
}

void PeopleLayer::subscribe([[maybe_unused]] const std::string& source, const std::string& topic) {
  ros::NodeHandle node;
  topic_ = node.resolveName(topic);
  const auto hints = ros::TransportHints().tcpNoDelay();
#ifdef SOCIAL_CROWD_PEOPLE_MSGS
  if (source == names::PEOPLE) {
    const boost::function<void(const people_msgs::People::ConstPtr&)> take = [this](const auto& message) {
      this->take(*message);
    };
    subscriber_ = node.subscribe<people_msgs::People>(topic, 1, take, ros::VoidConstPtr(), hints);
    return;
  }
#endif
  const boost::function<void(const social_crowd::AgentStates::ConstPtr&)> take = [this](const auto& message) {
    this->take(*message);
  };
  subscriber_ = node.subscribe<social_crowd::AgentStates>(topic, 1, take, ros::VoidConstPtr(), hints);
}

void PeopleLayer::take(const social_crowd::AgentStates& message) {
  People people = {message.header, {}};
  for (const social_crowd::AgentState& agent : message.agents) {
    if (isPresent(agent)) people.people.push_back({toVector(agent.pose), toVector(agent.velocity)});
  }
  for (const social_crowd::ObstacleState& obstacle : message.obstacles) {
    if (obstacle.recorded != 0) people.people.push_back({toVector(obstacle.position), toVector(obstacle.velocity)});
  }
  keep(std::move(people));
}

#ifdef SOCIAL_CROWD_PEOPLE_MSGS
void PeopleLayer::take(const people_msgs::People& message) {
  People people = {message.header, {}};
  for (const people_msgs::Person& person : message.people) {
    people.people.push_back({toVector(person.position), toVector(person.velocity)});
  }
  keep(std::move(people));
}
#endif

void PeopleLayer::keep(People people) {
  const auto is_bad = [](const Person& person) { return !person.place.allFinite() || !person.velocity.allFinite(); };
  const auto bad = std::remove_if(people.people.begin(), people.people.end(), is_bad);
  if (bad != people.people.end()) {
    ROS_WARN_THROTTLE(WARN_PERIOD, "%s: people whose position or velocity is not finite are left out", topic_.c_str());
    people.people.erase(bad, people.people.end());
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  people_ = std::move(people);
}

void PeopleLayer::reset() {
  const std::lock_guard<std::mutex> lock(mutex_);
  people_.people.clear();
}

void PeopleLayer::readParameters() {
  constexpr double POSITIVE = std::numeric_limits<double>::min();
  parameters_.getParamCached("enabled", draws_);
  spec_.amplitude = number("amplitude", spec_.amplitude, 1.0, MAX_COST);
  spec_.cutoff = number("cutoff", spec_.cutoff, 1.0, MAX_COST);
  spec_.spread = number("spread", spec_.spread, POSITIVE, UNLIMITED);
  spec_.stretch = number("stretch", spec_.stretch, 0.0, UNLIMITED);
  spec_.horizon = number("horizon", spec_.horizon, 0.0, UNLIMITED);
  timeout_ = number("timeout", timeout_, 0.0, UNLIMITED);
}

double PeopleLayer::number(const std::string& name, double present, double low, double high) {
  XmlRpc::XmlRpcValue value;
  if (!parameters_.getParamCached(name, value)) return present;
  double number = std::nan("");
  if (value.getType() == XmlRpc::XmlRpcValue::TypeDouble) number = static_cast<double>(value);
  if (value.getType() == XmlRpc::XmlRpcValue::TypeInt) number = static_cast<int>(value);
  if (std::isfinite(number) && number >= low && number <= high) return number;
  std::ostringstream got;
  got << value;
  if (std::exchange(reported_[name], got.str()) != got.str()) {
    ROS_WARN("%s/%s: expected a number from %g to %g, got %s; it stays %g", parameters_.getNamespace().c_str(),
             name.c_str(), low, high, got.str().c_str(), present);
  }
  return present;
}

std::vector<PersonalSpace> PeopleLayer::spacesOf(const People& people) const {
  if (!draws_ || people.people.empty()) return {};
  const double age = (ros::Time::now() - people.header.stamp).toSec();
  if (std::abs(age) > timeout_) {
    ROS_WARN_THROTTLE(WARN_PERIOD, "%s: the people are %.1f s old and not used", topic_.c_str(), age);
    return {};
  }
  Pose frame;
  try {
    frame = fromMessage(
        tf_->lookupTransform(layered_costmap_->getGlobalFrameID(), people.header.frame_id, ros::Time()).transform);
  } catch (const tf2::TransformException& error) {
    ROS_WARN_THROTTLE(WARN_PERIOD, "%s: the people are not used: %s", topic_.c_str(), error.what());
    return {};
  }
  const Rotation rotation(frame.heading);
  std::vector<PersonalSpace> spaces;
  for (const Person& person : people.people) {
    const Vector2 place = frame.position + rotation.outOfFrame(person.place + std::max(0.0, age) * person.velocity);
    const PersonalSpace space(spec_, place, rotation.outOfFrame(person.velocity));
    if (isNear(space.bounds())) spaces.push_back(space);
  }
  return spaces;
}

bool PeopleLayer::isNear(const Bounds& bounds) const {
  const costmap_2d::Costmap2D& costmap = *layered_costmap_->getCostmap();
  const Vector2 low(costmap.getOriginX(), costmap.getOriginY());
  const Vector2 high = low + Vector2(costmap.getSizeInMetersX(), costmap.getSizeInMetersY());
  return (bounds.low.array() <= high.array()).all() && (bounds.high.array() >= low.array()).all() &&
         (bounds.low.array() <= bounds.high.array()).all();
}

void PeopleLayer::updateBounds(double /*robot_x*/, double /*robot_y*/, double /*robot_yaw*/, double* min_x,
                               double* min_y, double* max_x, double* max_y) {
  readParameters();
  People people;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    people = people_;
  }
  spaces_ = spacesOf(people);
  Bounds all = {{*min_x, *min_y}, {*max_x, *max_y}};
  for (const Bounds& bounds : drawn_) extend(all, bounds);
  drawn_.clear();
  for (const PersonalSpace& space : spaces_) {
    if (drawn_.empty()) drawn_.push_back(space.bounds());
    extend(drawn_.front(), space.bounds());
  }
  for (const Bounds& bounds : drawn_) extend(all, bounds);
  *min_x = all.low.x();
  *min_y = all.low.y();
  *max_x = all.high.x();
  *max_y = all.high.y();
}

void PeopleLayer::updateCosts(costmap_2d::Costmap2D& costmap, int min_i, int min_j, int max_i, int max_j) {
  for (const PersonalSpace& space : spaces_) {
    const Bounds bounds = space.bounds();
    int low_i = 0;
    int low_j = 0;
    int high_i = 0;
    int high_j = 0;
    costmap.worldToMapNoBounds(bounds.low.x(), bounds.low.y(), low_i, low_j);
    costmap.worldToMapNoBounds(bounds.high.x(), bounds.high.y(), high_i, high_j);
    for (int j = std::max(min_j, low_j); j < std::min(max_j, high_j + 1); ++j) {
      for (int i = std::max(min_i, low_i); i < std::min(max_i, high_i + 1); ++i) {
        const unsigned char present = costmap.getCost(i, j);
        if (present == costmap_2d::NO_INFORMATION) continue;
        Vector2 point;
        costmap.mapToWorld(i, j, point.x(), point.y());
        costmap.setCost(i, j, std::max(present, static_cast<unsigned char>(space.costAt(point))));
      }
    }
  }
}

}  // namespace crowd

PLUGINLIB_EXPORT_CLASS(crowd::PeopleLayer, costmap_2d::Layer)
