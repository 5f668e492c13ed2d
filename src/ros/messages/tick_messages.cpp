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

  template <typename... Fields>
  void operator()(const Fields&... fields) {
    (put(fields), ...);
  }

 private:
  void put(const Vector2& v) { (*this)(v.x(), v.y()); }
  template <typename Number>
  void put(const Number& number) {
    std::memcpy(place_, &number, sizeof(number));
    place_ += sizeof(number);
  }

  std::uint8_t* place_;
};

/// Reads numbers consecutively from a buffer.
class Reader {
 public:
  explicit Reader(const std::uint8_t* place) : place_(place) {}

  template <typename... Fields>
  void operator()(Fields&... fields) {
    (take(fields), ...);
  }

 private:
  void take(Vector2& v) { (*this)(v.x(), v.y()); }
  void take(bool& flag) { flag = *place_++ != 0; }
  template <typename Number>
  void take(Number& number) {
    std::memcpy(&number, place_, sizeof(number));
    place_ += sizeof(number);
  }

  const std::uint8_t* place_;
};

// The fields of elements of lists, in the order of the wire, for a Writer or a Reader.

template <typename Stream>
void pass(Stream& stream, AgentPerception& self) {
  stream(self.agent, self.pose.position, self.pose.heading, self.velocity, self.max_speed, self.radius, self.goal,
         self.goal_number, self.arrived, self.acted, self.held, self.first_neighbour, self.neighbour_count,
         self.first_wall, self.wall_count);
}

template <typename Stream>
void pass(Stream& stream, Segment& wall) {
  stream(wall.from, wall.to);
}

template <typename Stream>
void pass(Stream& stream, AgentAction& action) {
  stream(action.agent, action.action.rotation, action.action.speed_fraction);
}

Neighbour takeNeighbour(Reader& reader) {
  Neighbour neighbour;
  std::uint8_t kind = 0;
  reader(kind, neighbour.position, neighbour.velocity, neighbour.radius);
  const bool is_known = kind <= social_crowd::Neighbour::UNYIELDED_ROBOT;
  neighbour.kind = is_known ? static_cast<NeighbourKind>(kind) : NeighbourKind::OBSTACLE;
  return neighbour;
}

/// Writes the length of a list and reserves space for its elements.
Writer beginList(OStream& stream, std::size_t count, std::uint32_t size) {
  stream.next(static_cast<std::uint32_t>(count));
  return Writer(stream.advance(static_cast<std::uint32_t>(count) * size));
}

template <typename Element>
void putList(OStream& stream, const std::vector<Element>& list, std::uint32_t size) {
  Writer writer = beginList(stream, list.size(), size);
  for (Element element : list) pass(writer, element);
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
  for (Element& element : list) pass(reader, element);
}

void takeIntents(IStream& stream, NeighbourList& neighbours) {
  std::uint32_t count = 0;
  Reader reader = openList(stream, count, WIRE_INTENT);
  for (std::size_t i = 0; i < neighbours.size() && count > 0; ++i) {
    Neighbour neighbour = neighbours[i];
    if (!isRobot(neighbour.kind)) continue;
    reader(neighbour.intent.comfort, neighbour.intent.wanted);
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
    AgentPerception self = content.agents[row];
    self.first_neighbour = first.neighbours;
    self.first_wall = first.walls;
    pass(agents, self);
    first.neighbours += self.neighbour_count;
    first.walls += self.wall_count;
  });
  Writer neighbours = beginList(stream, counts.neighbours, WIRE_NEIGHBOUR);
  forEachRow(message, [&](std::size_t row) {
    for (const Neighbour& neighbour : Perception(content, row).neighbours) {
      neighbours(static_cast<std::uint8_t>(neighbour.kind), neighbour.position, neighbour.velocity, neighbour.radius);
    }
  });
  Writer walls = beginList(stream, counts.walls, WIRE_WALL);
  forEachRow(message, [&](std::size_t row) {
    for (Segment wall : Perception(content, row).walls) pass(walls, wall);
  });
  Writer robots = beginList(stream, counts.robots, WIRE_INTENT);
  if (counts.robots == 0) return;
  forEachRow(message, [&](std::size_t row) {
    for (const Neighbour& neighbour : Perception(content, row).neighbours) {
      if (isRobot(neighbour.kind)) robots(neighbour.intent.comfort, neighbour.intent.wanted);
    }
  });
}

}  // namespace

}  // namespace crowd

namespace ros::serialization {
namespace {

template <typename Stream, typename... Fields>
void next(Stream& stream, Fields&&... fields) {
  (stream.next(fields), ...);
}

}  // namespace

using crowd::ActionsMessage;
using crowd::Perceptions;
using crowd::PerceptionsMessage;

void Serializer<PerceptionsMessage>::write(OStream& stream, const PerceptionsMessage& message) {
  const Perceptions& content = message.content();
  const crowd::Vision& vision = message.vision;
  const crowd::MotionFields motion = crowd::toFields(content.motion);
  next(stream, message.header, content.episode, content.tick, content.turn, content.tick_duration, message.run,
       std::uint8_t{content.last}, vision.radius, vision.max_neighbours, std::uint8_t{vision.occlusion},
       crowd::wallDistanceField(vision), message.motion_source, motion.acceleration, motion.braking, motion.turn_rate);
  crowd::putLists(stream, message);
}

void Serializer<PerceptionsMessage>::read(IStream& stream, PerceptionsMessage& message) {
  message.shared.reset();
  message.rows.reset();
  Perceptions& content = message.received;
  crowd::Vision& vision = message.vision;
  std::uint8_t last = 0;
  std::uint8_t occlusion = 0;
  double wall_distance = 0.0;
  crowd::MotionFields motion;
  next(stream, message.header, content.episode, content.tick, content.turn, content.tick_duration, message.run, last,
       vision.radius, vision.max_neighbours, occlusion, wall_distance, message.motion_source, motion.acceleration,
       motion.braking, motion.turn_rate);
  content.last = last != 0;
  content.motion = crowd::fromFields(motion);
  vision.occlusion = occlusion != 0;
  vision.wall_distance = crowd::wallDistanceOf(wall_distance);
  vision.motion = crowd::requestOf(message.motion_source, content.motion);
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
  next(stream, message.header, message.content.episode, message.content.tick, message.run, message.node);
  crowd::putList(stream, message.content.agents, crowd::WIRE_ACTION);
}

void Serializer<ActionsMessage>::read(IStream& stream, ActionsMessage& message) {
  next(stream, message.header, message.content.episode, message.content.tick, message.run, message.node);
  crowd::takeList(stream, message.content.agents, crowd::WIRE_ACTION);
}

std::uint32_t Serializer<ActionsMessage>::serializedLength(const ActionsMessage& message) {
  const auto lists = static_cast<std::uint32_t>(message.content.agents.size()) * crowd::WIRE_ACTION;
  return serializationLength(message.header) + serializationLength(message.node) + crowd::WIRE_ACTIONS + lists;
}

}  // namespace ros::serialization
