#include "ros/messages/tick_messages.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "ros/messages/motion_fields.h"
#include "ros/messages/vision.h"

namespace crowd {
namespace {

using ros::serialization::IStream;
using ros::serialization::OStream;

// Sizes on the wire [bytes], from the .msg files.
constexpr std::uint32_t NUMBER = sizeof(double);
constexpr std::uint32_t COUNT = sizeof(std::uint32_t);
constexpr std::uint32_t WIRE_NEIGHBOUR = 1 + 5 * NUMBER;
constexpr std::uint32_t WIRE_WALL = 4 * NUMBER;
constexpr std::uint32_t WIRE_INTENT = 3 * NUMBER;
constexpr std::uint32_t WIRE_SELF = COUNT + 9 * NUMBER + COUNT + 3 + 4 * COUNT;
constexpr std::uint32_t WIRE_ACTION = COUNT + 2 * NUMBER;
constexpr std::uint32_t WIRE_PERCEPTIONS = 9 * NUMBER + 2 * COUNT + 3 + 4 * COUNT;  // without header and lists
constexpr std::uint32_t WIRE_ACTIONS = 3 * NUMBER + COUNT;                          // without header, name and list

/// Writes numbers consecutively to a buffer. The size is reserved once per list.
class Writer {
 public:
  explicit Writer(std::uint8_t* place) : place_(place) {}

  template <typename... Numbers>
  void put(const Numbers&... numbers) {
    (putOne(numbers), ...);
  }
  void put(const Vector2& v) { put(v.x(), v.y()); }

 private:
  template <typename Number>
  void putOne(const Number& number) {
    std::memcpy(place_, &number, sizeof(number));
    place_ += sizeof(number);
  }

  std::uint8_t* place_;
};

/// Reads numbers consecutively from a buffer.
class Reader {
 public:
  explicit Reader(const std::uint8_t* place) : place_(place) {}

  template <typename Number>
  void take(Number& number) {
    std::memcpy(&number, place_, sizeof(number));
    place_ += sizeof(number);
  }
  void take(Vector2& v) {
    take(v.x());
    take(v.y());
  }
  void take(bool& flag) { flag = takeByte() != 0; }
  std::uint8_t takeByte() { return *place_++; }

 private:
  const std::uint8_t* place_;
};

void put(Writer& writer, const AgentPerception& self, std::uint32_t first_neighbour, std::uint32_t first_wall) {
  writer.put(self.agent);
  writer.put(self.pose.position);
  writer.put(self.pose.heading);
  writer.put(self.velocity);
  writer.put(self.max_speed, self.radius);
  writer.put(self.goal);
  writer.put(self.goal_number, std::uint8_t{self.arrived}, std::uint8_t{self.acted}, std::uint8_t{self.held});
  writer.put(first_neighbour, self.neighbour_count, first_wall, self.wall_count);
}

void take(Reader& reader, AgentPerception& self) {
  reader.take(self.agent);
  reader.take(self.pose.position);
  reader.take(self.pose.heading);
  reader.take(self.velocity);
  reader.take(self.max_speed);
  reader.take(self.radius);
  reader.take(self.goal);
  reader.take(self.goal_number);
  reader.take(self.arrived);
  reader.take(self.acted);
  reader.take(self.held);
  reader.take(self.first_neighbour);
  reader.take(self.neighbour_count);
  reader.take(self.first_wall);
  reader.take(self.wall_count);
}

void put(Writer& writer, const Neighbour& neighbour) {
  writer.put(static_cast<std::uint8_t>(neighbour.kind));
  writer.put(neighbour.position);
  writer.put(neighbour.velocity);
  writer.put(neighbour.radius);
}

Neighbour takeNeighbour(Reader& reader) {
  Neighbour neighbour;
  const std::uint8_t kind = reader.takeByte();
  const bool is_known = kind <= social_crowd::Neighbour::UNYIELDED_ROBOT;
  neighbour.kind = is_known ? static_cast<NeighbourKind>(kind) : NeighbourKind::OBSTACLE;
  reader.take(neighbour.position);
  reader.take(neighbour.velocity);
  reader.take(neighbour.radius);
  return neighbour;
}

void put(Writer& writer, const Segment& wall) {
  writer.put(wall.from);
  writer.put(wall.to);
}

void take(Reader& reader, Segment& wall) {
  reader.take(wall.from);
  reader.take(wall.to);
}

void put(Writer& writer, const AgentAction& action) {
  writer.put(action.agent, action.action.rotation, action.action.speed_fraction);
}

void take(Reader& reader, AgentAction& action) {
  reader.take(action.agent);
  reader.take(action.action.rotation);
  reader.take(action.action.speed_fraction);
}

/// Writes the length of a list and reserves space for its elements.
Writer beginList(OStream& stream, std::size_t count, std::uint32_t size) {
  stream.next(static_cast<std::uint32_t>(count));
  return Writer(stream.advance(static_cast<std::uint32_t>(count) * size));
}

template <typename Element>
void putList(OStream& stream, const std::vector<Element>& list, std::uint32_t size) {
  Writer writer = beginList(stream, list.size(), size);
  for (const Element& element : list) put(writer, element);
}

/// Reads the length of a list; the reader is at its first element. @throws StreamOverrunException if the message is too
/// short
Reader openList(IStream& stream, std::uint32_t& count, std::uint32_t size) {
  stream.next(count);
  if (count > stream.getLength() / size) ros::serialization::throwStreamOverrun();
  return Reader(stream.advance(count * size));
}

template <typename Element>
void takeList(IStream& stream, std::vector<Element>& list, std::uint32_t size) {
  std::uint32_t count = 0;
  Reader reader = openList(stream, count, size);
  list.resize(count);
  for (Element& element : list) take(reader, element);
}

void takeIntents(IStream& stream, NeighbourList& neighbours) {
  std::uint32_t count = 0;
  Reader reader = openList(stream, count, WIRE_INTENT);
  for (std::size_t i = 0; i < neighbours.size() && count > 0; ++i) {
    Neighbour neighbour = neighbours[i];
    if (!isRobot(neighbour.kind)) continue;
    reader.take(neighbour.intent.comfort);
    reader.take(neighbour.intent.wanted);
    neighbours.set(i, neighbour);
    --count;
  }
}

void takeNeighbours(IStream& stream, NeighbourList& neighbours) {
  std::uint32_t count = 0;
  Reader reader = openList(stream, count, WIRE_NEIGHBOUR);
  neighbours.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) neighbours.set(i, takeNeighbour(reader));
}

/// Lengths of the lists on the wire.
struct Counts {
  std::uint32_t agents = 0;
  std::uint32_t neighbours = 0;
  std::uint32_t walls = 0;
  std::uint32_t robots = 0;  // among the neighbours
};

/// Calls a function with the index of each agent that is serialised.
template <typename Visit>
void forEachRow(const PerceptionsMessage& message, const Visit& visit) {
  if (message.rows) {
    for (const std::uint32_t row : *message.rows) visit(row);
  } else {
    for (std::size_t row = 0; row < message.content().agents.size(); ++row) visit(row);
  }
}

std::size_t robotsAmong(const NeighbourSpan& neighbours) {
  return static_cast<std::size_t>(std::count_if(neighbours.kinds(), neighbours.kinds() + neighbours.size(), isRobot));
}

Counts countsOf(const PerceptionsMessage& message) {
  Counts counts;
  forEachRow(message, [&, &agents = message.content().agents](std::size_t row) {
    ++counts.agents;
    counts.neighbours += agents[row].neighbour_count;
    counts.walls += agents[row].wall_count;
    const NeighbourSpan neighbours = Perception(message.content(), row).neighbours;
    if (neighbours.hasObstacles()) counts.robots += static_cast<std::uint32_t>(robotsAmong(neighbours));
  });
  return counts;
}

/// Writes neighbours and walls agent by agent, without the gaps between them.
void putLists(OStream& stream, const PerceptionsMessage& message) {
  const Perceptions& content = message.content();
  const Counts counts = countsOf(message);
  Writer agents = beginList(stream, counts.agents, WIRE_SELF);
  Counts first;
  forEachRow(message, [&](std::size_t row) {
    const AgentPerception& self = content.agents[row];
    put(agents, self, first.neighbours, first.walls);
    first.neighbours += self.neighbour_count;
    first.walls += self.wall_count;
  });
  Writer neighbours = beginList(stream, counts.neighbours, WIRE_NEIGHBOUR);
  forEachRow(message, [&](std::size_t row) {
    for (const Neighbour& neighbour : Perception(content, row).neighbours) put(neighbours, neighbour);
  });
  Writer walls = beginList(stream, counts.walls, WIRE_WALL);
  forEachRow(message, [&](std::size_t row) {
    for (const Segment& wall : Perception(content, row).walls) put(walls, wall);
  });
  Writer robots = beginList(stream, counts.robots, WIRE_INTENT);
  if (counts.robots == 0) return;
  forEachRow(message, [&](std::size_t row) {
    for (const Neighbour& neighbour : Perception(content, row).neighbours) {
      if (!isRobot(neighbour.kind)) continue;
      robots.put(neighbour.intent.comfort);
      robots.put(neighbour.intent.wanted);
    }
  });
}

}  // namespace

}  // namespace crowd

namespace ros::serialization {

using crowd::ActionsMessage;
using crowd::Perceptions;
using crowd::PerceptionsMessage;

void Serializer<PerceptionsMessage>::write(OStream& stream, const PerceptionsMessage& message) {
  const Perceptions& content = message.content();
  stream.next(message.header);
  stream.next(content.episode);
  stream.next(content.tick);
  stream.next(content.turn);
  stream.next(content.tick_duration);
  stream.next(message.run);
  stream.next(std::uint8_t{content.last});
  stream.next(message.vision.radius);
  stream.next(message.vision.max_neighbours);
  stream.next(std::uint8_t{message.vision.occlusion});
  stream.next(crowd::wallDistanceField(message.vision));
  const crowd::MotionFields motion = crowd::toFields(content.motion);
  stream.next(message.motion_source);
  stream.next(motion.acceleration);
  stream.next(motion.braking);
  stream.next(motion.turn_rate);
  crowd::putLists(stream, message);
}

void Serializer<PerceptionsMessage>::read(IStream& stream, PerceptionsMessage& message) {
  message.shared.reset();
  message.rows.reset();
  Perceptions& content = message.received;
  std::uint8_t last = 0;
  std::uint8_t occlusion = 0;
  double wall_distance = 0.0;
  stream.next(message.header);
  stream.next(content.episode);
  stream.next(content.tick);
  stream.next(content.turn);
  stream.next(content.tick_duration);
  stream.next(message.run);
  stream.next(last);
  stream.next(message.vision.radius);
  stream.next(message.vision.max_neighbours);
  stream.next(occlusion);
  stream.next(wall_distance);
  crowd::MotionFields motion;
  stream.next(message.motion_source);
  stream.next(motion.acceleration);
  stream.next(motion.braking);
  stream.next(motion.turn_rate);
  content.last = last != 0;
  message.vision.occlusion = occlusion != 0;
  message.vision.wall_distance = crowd::wallDistanceOf(wall_distance);
  content.motion = crowd::fromFields(motion);
  message.vision.motion = crowd::requestOf(message.motion_source, content.motion);
  crowd::takeList(stream, content.agents, crowd::WIRE_SELF);
  crowd::takeNeighbours(stream, content.neighbours);
  crowd::takeList(stream, content.walls, crowd::WIRE_WALL);
  crowd::takeIntents(stream, content.neighbours);
}

std::uint32_t Serializer<PerceptionsMessage>::serializedLength(const PerceptionsMessage& message) {
  const crowd::Counts counts = crowd::countsOf(message);
  const std::uint32_t lists = counts.agents * crowd::WIRE_SELF + counts.neighbours * crowd::WIRE_NEIGHBOUR +
                              counts.walls * crowd::WIRE_WALL + counts.robots * crowd::WIRE_INTENT;
  return serializationLength(message.header) + crowd::WIRE_PERCEPTIONS + lists;
}

void Serializer<ActionsMessage>::write(OStream& stream, const ActionsMessage& message) {
  stream.next(message.header);
  stream.next(message.content.episode);
  stream.next(message.content.tick);
  stream.next(message.run);
  stream.next(message.node);
  crowd::putList(stream, message.content.agents, crowd::WIRE_ACTION);
}

void Serializer<ActionsMessage>::read(IStream& stream, ActionsMessage& message) {
  stream.next(message.header);
  stream.next(message.content.episode);
  stream.next(message.content.tick);
  stream.next(message.run);
  stream.next(message.node);
  crowd::takeList(stream, message.content.agents, crowd::WIRE_ACTION);
}

std::uint32_t Serializer<ActionsMessage>::serializedLength(const ActionsMessage& message) {
  const auto lists = static_cast<std::uint32_t>(message.content.agents.size()) * crowd::WIRE_ACTION;
  return serializationLength(message.header) + serializationLength(message.node) + crowd::WIRE_ACTIONS + lists;
}

}  // namespace ros::serialization
