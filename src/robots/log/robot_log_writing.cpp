#include "robots/log/robot_log_writing.h"

#include <array>
#include <cstdio>

#include "common/text/numbers.h"

namespace crowd {
namespace {

std::string quoted(const std::string& text) {
  std::string json = "\"";
  for (const char character : text) {
    if (character == '"' || character == '\\') {
      json += '\\';
      json += character;
    } else if (static_cast<unsigned char>(character) < 0x20) {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\u%04x", static_cast<unsigned>(character));
      json += code.data();
    } else {
      json += character;
    }
  }
  return json + "\"";
}

/// Writes an object or a list, with commas between its members.
class Members {
 public:
  Members(char open, char close, std::string& text) : close_(close), text_(text) { text_ += open; }
  Members(const Members&) = delete;
  Members& operator=(const Members&) = delete;
  Members(Members&&) = delete;
  Members& operator=(Members&&) = delete;
  ~Members() { text_ += close_; }

  /// Begins a member of a list.
  std::string& next() {
    if (!is_first_) text_ += ", ";
    is_first_ = false;
    return text_;
  }
  /// Begins a member of an object.
  std::string& next(const char* key) { return next() += std::string("\"") + key + "\": "; }
  void number(const char* key, double value) { appendText(value, next(key)); }
  void count(const char* key, std::uint64_t value) { next(key) += std::to_string(value); }
  void flag(const char* key, bool value) { next(key) += value ? "true" : "false"; }
  void text(const char* key, const std::string& value) { next(key) += quoted(value); }

 private:
  char close_;
  std::string& text_;
  bool is_first_ = true;
};

/// Writes [1, 2.5].
template <typename... Numbers>
void appendNumbers(std::string& text, const Numbers&... numbers) {
  Members list('[', ']', text);
  (appendText(numbers, list.next()), ...);
}

/// Writes a list; append(item, text) writes an item.
template <typename Item, typename Append>
void appendList(const std::vector<Item>& items, std::string& text, const Append& append) {
  Members list('[', ']', text);
  for (const Item& item : items) append(item, list.next());
}

void appendPoint(const Vector2& point, std::string& text) { appendNumbers(text, point.x(), point.y()); }

void appendWalls(const std::vector<Segment>& walls, std::string& text) {
  appendList(walls, text, [](const Segment& wall, std::string& to) {
    appendNumbers(to, wall.from.x(), wall.from.y(), wall.to.x(), wall.to.y());
  });
}

void appendObstacles(const std::vector<ObservedObstacle>& obstacles, std::string& text) {
  appendList(obstacles, text, [](const ObservedObstacle& obstacle, std::string& to) {
    appendNumbers(to, obstacle.position.x(), obstacle.position.y(), obstacle.radius);
  });
}

void appendRobot(const RobotStart& robot, std::string& text) {
  Members object('{', '}', text);
  object.text("name", robot.name);
  if (robot.footprint.isDisc()) {
    object.number("radius", robot.footprint.radius);
  } else {
    appendList(robot.footprint.corners, object.next("footprint"), appendPoint);
  }
  if (robot.limits.max_speed > 0.0) object.number("max_speed", robot.limits.max_speed);
  if (!robot.goals.empty()) appendList(robot.goals, object.next("goals"), appendPoint);
  if (!robot.goals.empty()) object.number("goal_tolerance", robot.goal_tolerance);
}

void appendContact(const RobotContact& contact, std::string& text) {
  Members object('{', '}', text);
  object.count("person", contact.agent);
  object.text("cause", CONTACT_CAUSES.nameOf(contact.cause));
  object.flag("begins", contact.begins);
}

/// Writes x, y, heading, vx and vy.
void appendMotion(const Vector2& place, const std::optional<double>& heading, const std::optional<Vector2>& velocity,
                  Members& object) {
  object.number("x", place.x());
  object.number("y", place.y());
  if (heading) object.number("heading", *heading);
  if (!velocity) return;
  object.number("vx", velocity->x());
  object.number("vy", velocity->y());
}

void appendRobot(const LoggedRobot& robot, std::string& text) {
  Members object('{', '}', text);
  appendMotion(robot.pose.position, robot.pose.heading, robot.velocity, object);
  if (robot.impact) object.flag("impact", *robot.impact);
  if (robot.jump) object.flag("jump", true);
  if (robot.contacts) appendList(*robot.contacts, object.next("contacts"), appendContact);
}

void appendPerson(const LoggedPerson& person, std::string& text) {
  Members object('{', '}', text);
  object.count("id", person.id);
  appendMotion(person.position, person.heading, person.velocity, object);
  if (person.radius) object.number("radius", *person.radius);
  if (person.group) object.count("group", *person.group);
  if (person.goal) appendPoint(*person.goal, object.next("goal"));
  if (person.endless) object.flag("endless", *person.endless);
}

}  // namespace

void appendLogLine(const RobotLogHeader& header, std::string& text) {
  {
    Members object('{', '}', text);
    object.text("scenario", header.scenario);
    object.count("episode", header.episode);
    object.number("tick_duration", header.tick_duration);
    if (!header.map.empty()) object.text("map", header.map);
    appendWalls(header.walls, object.next("walls"));
    if (!header.gates.empty()) appendWalls(header.gates, object.next("gates"));
    appendObstacles(header.obstacles, object.next("obstacles"));
    appendList(header.robots, object.next("robots"),
               [](const RobotStart& robot, std::string& to) { appendRobot(robot, to); });
  }
  text += '\n';
}

void appendLogLine(const RobotLogTick& tick, std::string& text) {
  {
    Members object('{', '}', text);
    object.count("tick", tick.tick);
    appendList(tick.robots, object.next("robots"),
               [](const LoggedRobot& robot, std::string& to) { appendRobot(robot, to); });
    appendList(tick.people, object.next("people"), appendPerson);
    if (!tick.arrived.empty()) {
      appendList(tick.arrived, object.next("arrived"), [](AgentId id, std::string& to) { to += std::to_string(id); });
    }
    if (!tick.obstacles.empty()) appendObstacles(tick.obstacles, object.next("obstacles"));
    if (tick.walls) appendWalls(*tick.walls, object.next("walls"));
  }
  text += '\n';
}

}  // namespace crowd
