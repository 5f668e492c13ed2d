#include "robots/log/robot_log_reading.h"

#include <algorithm>
#include <limits>

#include "common/text/numbers.h"
#include "geometry/limits.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/robot_reader.h"

namespace crowd {
namespace {

constexpr std::size_t LINES_AT_ONCE = 64;  // that are parsed together

/// Reads a list of a fixed number of numbers.
std::vector<double> readNumbers(const YAML::Node& node, const YamlPlace& place, const char* expected, std::size_t count,
                                const NumberLimit& limit) {
  if (!node.IsDefined() || !node.IsSequence() || node.size() != count) throwExpected(place, node, expected);
  return readList<double>(node, place,
                          [&](const YAML::Node& number, const YamlPlace& at) { return readNumber(number, at, limit); });
}

std::vector<Segment> readWalls(const YAML::Node& node, const YamlPlace& place) {
  return readList<Segment>(node, place, [](const YAML::Node& wall, const YamlPlace& at) {
    const std::vector<double> ends = readNumbers(wall, at, "[x1, y1, x2, y2]", 4, limits::PLACE);
    return Segment{{ends[0], ends[1]}, {ends[2], ends[3]}};
  });
}

std::vector<ObservedObstacle> readObstacles(const YAML::Node& node, const YamlPlace& place, bool moves) {
  return readList<ObservedObstacle>(node, place, [moves](const YAML::Node& obstacle, const YamlPlace& at) {
    const std::vector<double> disc = readNumbers(obstacle, at, "[x, y, radius]", 3, limits::PLACE);
    if (disc[2] <= 0.0) throwProblem(at, obstacle, "expected a radius above 0, got " + toText(disc[2]));
    return ObservedObstacle{{disc[0], disc[1]}, disc[2], moves};
  });
}

RobotStart readStart(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"name", "radius", "footprint", "max_speed", "goals", "goal_tolerance"});
  RobotStart start;
  start.name = map.has("name") ? readRobotName(map, "name") : "robot";
  start.drive = Drive::EXTERNAL;
  readFootprint(map, start.footprint);
  start.limits.max_speed = map.has("max_speed") ? map.number("max_speed", limits::SPEED) : 0.0;
  start.goals = readList<Vector2>(
      map.find("goals"), map.placeOf("goals"),
      [](const YAML::Node& goal, const YamlPlace& at) { return Vector2(readVector(goal, at, limits::PLACE)); });
  if (!start.goals.empty()) start.goal_tolerance = map.number("goal_tolerance", limits::DISTANCE);
  return start;
}

RobotLogHeader readHeader(const YAML::Node& node, const YamlPlace& place, std::uint64_t episode) {
  const YamlMap map(node, place,
                    {"scenario", "episode", "tick_duration", "map", "walls", "gates", "obstacles", "robots"});
  RobotLogHeader header;
  header.scenario = map.text("scenario", stemOf(place.file));
  header.episode = map.count("episode", episode);
  header.tick_duration = map.number("tick_duration", limits::TICK);
  header.map = map.text("map", "");
  header.walls = readWalls(map.find("walls"), map.placeOf("walls"));
  header.gates = readWalls(map.find("gates"), map.placeOf("gates"));
  header.obstacles = readObstacles(map.find("obstacles"), map.placeOf("obstacles"), false);
  const YAML::Node robots = map.need("robots");
  header.robots = readList<RobotStart>(robots, map.placeOf("robots"), readStart);
  if (header.robots.empty()) throwExpected(map.placeOf("robots"), robots, "at least one robot");
  return header;
}

/// Reads vx and vy; nothing if both are absent.
std::optional<Vector2> readVelocity(const YamlMap& map) {
  if (!map.has("vx") && !map.has("vy")) return std::nullopt;
  return Vector2(map.number("vx", limits::VELOCITY), map.number("vy", limits::VELOCITY));
}

Vector2 readPlace(const YamlMap& map) { return {map.number("x", limits::PLACE), map.number("y", limits::PLACE)}; }

AgentId readId(const YamlMap& map, const char* key) {
  return static_cast<AgentId>(map.whole(key, 0, std::numeric_limits<AgentId>::max()));
}

/// @param before contacts of the tick before, which go on
std::vector<RobotContact> readContacts(const YamlMap& map, const std::vector<RobotContact>& before) {
  return readList<RobotContact>(
      map.need("contacts"), map.placeOf("contacts"), [&](const YAML::Node& node, const YamlPlace& at) {
        const YamlMap contact(node, at, {"person", "cause", "begins"});
        const AgentId person = readId(contact, "person");
        const ContactCause cause = CONTACT_CAUSES.need(contact);
        const bool goes_on = std::any_of(before.begin(), before.end(),
                                         [&](const RobotContact& earlier) { return earlier.agent == person; });
        return RobotContact{person, cause, contact.flag("begins", !goes_on)};
      });
}

LoggedRobot readRobot(const YAML::Node& node, const YamlPlace& place, const std::vector<RobotContact>& before) {
  const YamlMap map(node, place, {"x", "y", "heading", "vx", "vy", "impact", "jump", "contacts"});
  LoggedRobot robot;
  robot.pose = {readPlace(map), map.number("heading", NumberRule::ANY)};
  robot.velocity = readVelocity(map);
  if (map.has("impact")) robot.impact = map.flag("impact", false);
  robot.jump = map.flag("jump", false);
  if (map.has("contacts")) robot.contacts = readContacts(map, before);
  return robot;
}

LoggedPerson readPerson(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"id", "x", "y", "heading", "vx", "vy", "radius", "group", "goal", "endless"});
  LoggedPerson person;
  person.id = readId(map, "id");
  person.position = readPlace(map);
  if (map.has("heading")) person.heading = map.number("heading", NumberRule::ANY);
  person.velocity = readVelocity(map);
  if (map.has("radius")) person.radius = map.number("radius", limits::RADIUS);
  if (map.has("group")) person.group = readId(map, "group");
  if (map.has("goal")) person.goal = readVector(map.need("goal"), map.placeOf("goal"), limits::PLACE);
  if (map.has("endless")) person.endless = map.flag("endless", false);
  return person;
}

/// Reads the lines of a log one after the other.
class LogReader {
 public:
  LogReader(const std::function<void(RobotLogHeader&)>& begin, const std::function<void(RobotLogTick&)>& add)
      : begin_(begin), add_(add) {}

  void read(const YAML::Node& line, const YamlPlace& place) {
    if (!line.IsMap()) throwExpected(place, line, "an object, {...}");
    if (line["tick_duration"]) return readBegin(line, place);
    if (line["tick"]) return readTick(line, place);
    throwProblem(place, line, "expected a header with the key 'tick_duration', or a tick with the key 'tick'");
  }

 private:
  void readBegin(const YAML::Node& line, const YamlPlace& place) {
    RobotLogHeader header = readHeader(line, place, episodes_);
    ++episodes_;
    robots_ = header.robots.size();
    last_.reset();
    contacts_.assign(robots_, {});
    begin_(header);
  }
  void readTick(const YAML::Node& line, const YamlPlace& place);
  static void requireDifferent(const YamlMap& map, const std::vector<LoggedPerson>& people);

  const std::function<void(RobotLogHeader&)>& begin_;
  const std::function<void(RobotLogTick&)>& add_;
  std::uint64_t episodes_ = 0;
  std::size_t robots_ = 0;
  std::optional<std::uint64_t> last_;                // tick
  std::vector<std::vector<RobotContact>> contacts_;  // of the last tick, by robot
};

void LogReader::readTick(const YAML::Node& line, const YamlPlace& place) {
  if (robots_ == 0) throwProblem(place, line, "expected a header with the key 'tick_duration' before the first tick");
  const YamlMap map(line, place, {"tick", "robots", "people", "arrived", "obstacles", "walls"});
  RobotLogTick tick;
  tick.line = static_cast<std::uint64_t>(lineOf(line));
  tick.tick = map.count("tick");
  if (last_ && tick.tick != *last_ + 1) {
    throwExpected(map.placeOf("tick"), map.need("tick"), std::to_string(*last_ + 1) + ", as ticks follow each other");
  }
  last_ = tick.tick;
  const YAML::Node robots = map.need("robots");
  if (!robots.IsSequence() || robots.size() != robots_) {
    throwExpected(map.placeOf("robots"), robots, "a list of " + std::to_string(robots_) + ", as in the header");
  }
  for (std::size_t i = 0; i < robots_; ++i) {
    tick.robots.push_back(readRobot(robots[i], map.placeOf("robots").element(i), contacts_[i]));
    contacts_[i] = tick.robots.back().contacts.value_or(std::vector<RobotContact>());
  }
  tick.people = readList<LoggedPerson>(map.find("people"), map.placeOf("people"), readPerson);
  requireDifferent(map, tick.people);
  tick.arrived =
      readList<AgentId>(map.find("arrived"), map.placeOf("arrived"), [](const YAML::Node& id, const YamlPlace& at) {
        return static_cast<AgentId>(readWhole(id, at, 0, std::numeric_limits<AgentId>::max()));
      });
  tick.obstacles = readObstacles(map.find("obstacles"), map.placeOf("obstacles"), true);
  if (map.has("walls")) tick.walls = readWalls(map.need("walls"), map.placeOf("walls"));
  add_(tick);
}

void LogReader::requireDifferent(const YamlMap& map, const std::vector<LoggedPerson>& people) {
  std::vector<AgentId> ids;
  ids.reserve(people.size());
  for (const LoggedPerson& person : people) ids.push_back(person.id);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice == ids.end()) return;
  throwProblem(map.placeOf("people"), map.need("people"), "there are two people " + std::to_string(*twice));
}

bool isEmptyLine(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

/// Whether a line is an object of its own; YAML is more than JSON.
bool isWholeObject(const std::string& line, const std::string& file) {
  try {
    return parseYamlStream(line, file).size() == 1;
  } catch (const InputError&) {
    return false;
  }
}

/// Parses some lines of a log together. In an object that is not complete, YAML goes on to the next line, so that the
/// message would have the number of that one.
std::vector<YAML::Node> parseLines(const std::vector<std::string>& lines, std::size_t first, const std::string& file) {
  std::string text(first, '\n');  // so that messages have the line of the file
  for (const std::string& line : lines) text += isEmptyLine(line) ? "\n" : "--- " + line + "\n";
  try {
    return parseYamlStream(text, file);
  } catch (const InputError&) {
    YAML::Mark mark;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      mark.line = static_cast<int>(first + i);
      if (!isEmptyLine(lines[i]) && !isWholeObject(lines[i], file)) {
        throwProblem({file, 0, ""}, mark, "this is not a complete line of JSON");
      }
    }
    throw;
  }
}

}  // namespace

void readRobotLog(const std::string& file, const std::function<void(RobotLogHeader&)>& begin,
                  const std::function<void(RobotLogTick&)>& add, FileKinds kinds) {
  const std::string text = readFile(file, FileLimits::RECORDING, kinds);
  LogReader reader(begin, add);
  std::size_t first = 0;
  for (std::size_t at = 0; at < text.size();) {
    std::vector<std::string> lines;
    while (lines.size() < LINES_AT_ONCE && at < text.size()) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      lines.push_back(text.substr(at, end - at));
      at = end + 1;
    }
    for (const YAML::Node& node : parseLines(lines, first, file)) reader.read(node, {file, 0, ""});
    first += lines.size();
  }
}

}  // namespace crowd
