#include "social_crowd/robot_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "common/text/quotes.h"
#include "common/text/suggestions.h"
#include "common/thread_pool.h"
#include "library/conversions.h"
#include "robots/robot_observation.h"
#include "robots/scan.h"
#include "scenario/scenario.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "simulation/evaluation/evaluation.h"
#include "social_crowd/errors.h"

namespace crowd::library {
namespace {

constexpr std::size_t COMMAND = 3;  // numbers of a command

/// Index of the robot of a scenario. @param name of the robot; empty: the first one
RobotId findRobot(const crowd::Scenario& scenario, const std::string& name) {
  std::vector<std::string> names;
  for (const RobotGroup& robot : scenario.robots) {
    if (name.empty() || robot.start.name == name) return static_cast<RobotId>(names.size());
    names.push_back(robot.start.name);
  }
  if (names.empty()) throw InputError(scenario.source + ": the scenario has no robot");
  throw InputError(scenario.source + ": there is no robot " + inQuotes(name) + ", only: " + joinNames(names));
}

RobotDescription describe(const crowd::RobotStart& start) {
  return {start.name,
          DRIVES.nameOf(start.drive),
          start.limits.max_speed,
          start.limits.max_rotation,
          start.footprint.reach(),
          start.scan.rays,
          start.scan.first_angle,
          angleIncrement(start.scan),
          start.scan.min_range,
          start.scan.max_range};
}

/// Whether policies for one robot fit the other one.
bool areAlike(const RobotDescription& a, const RobotDescription& b) {
  return a.drive == b.drive && a.max_speed == b.max_speed && a.max_rotation == b.max_rotation && a.rays == b.rays &&
         a.first_angle == b.first_angle && a.angle_increment == b.angle_increment && a.min_range == b.min_range &&
         a.max_range == b.max_range;
}

template <typename Number>
void put(const Vector2& vector, Number* to) {
  to[0] = vector.x;
  to[1] = vector.y;
}

}  // namespace

struct RobotBatch::State {
  /// One episode.
  struct Element {
    std::unique_ptr<crowd::Episode> episode;  // null: none has begun
    std::optional<RobotSenses> senses;
    RobotId robot = 0;
    std::vector<RobotContact> contacts;  // of the ticks of this step
  };
  /// What a worker needs to decide for people.
  struct Worker {
    explicit Worker(const TrainedTable& trained) : learner(makeDemoLearner(trained, 1)), decider(learner) {}

    crowd::Learner learner;
    CrowdDecider decider;
  };

  State(std::vector<Scenario> all, const QTable& q_table, const RobotBatchOptions& wanted)
      : scenarios(std::move(all)),
        table(q_table),
        vision(table.trained().model.vision()),
        options(wanted),
        pool(std::min<unsigned>(ThreadPool::countFor(wanted.threads), static_cast<unsigned>(wanted.size))),
        elements(wanted.size) {
    if (options.size == 0) throw InputError("size: expected at least one episode");
    if (options.ticks == 0) throw InputError("ticks: expected at least one");
    findRobots();
    for (unsigned i = 0; i < pool.count(); ++i) workers.push_back(std::make_unique<Worker>(table.trained()));
    const std::size_t n = options.size;
    for (auto* const triples : {&arrays.pose, &arrays.twist}) triples->resize(3 * n);
    arrays.goal.resize(2 * n);
    for (auto* const numbers : {&arrays.remaining_distance, &arrays.clearance}) numbers->resize(n);
    for (auto* const counts :
         {&arrays.contacts, &arrays.contacts_by_robot, &arrays.contacts_by_person, &arrays.people_count}) {
      counts->resize(n);
    }
    for (auto* const flags : {&arrays.has_goal, &arrays.arrived, &arrays.blocked, &arrays.over}) flags->resize(n);
    arrays.tick.resize(n);
    arrays.scan.resize(options.scan ? n * robot.rays : 0);
    arrays.people.resize(n * options.max_people * RobotArrays::PERSON);
  }

  /// Finds the robot in all documents of all scenarios.
  void findRobots() {
    if (scenarios.empty()) throw InputError("scenarios: expected at least one");
    bool is_first = true;
    for (const Scenario& scenario : scenarios) {
      std::vector<RobotId>& documents = robots.emplace_back();
      for (std::size_t i = 0; i < scenario.list().size(); ++i) {
        const crowd::Scenario& document = scenario.list()[i];
        documents.push_back(findRobot(document, options.robot));
        const crowd::RobotStart& start = document.robots[documents.back()].start;
        const RobotDescription described = describe(start);
        if (start.drive == Drive::EXTERNAL) {
          throw InputError(document.source + ": robot " + inQuotes(start.name) +
                           ": expected one that takes commands, got drive: external");
        }
        if (is_first) robot = described;
        is_first = false;
        if (!areAlike(robot, described)) {
          throw InputError(document.source + ": robot " + inQuotes(start.name) +
                           ": expected drive, greatest speeds and scanner of the robot of the first scenario");
        }
      }
    }
  }

  const Element& require(std::size_t element) const {
    if (element < elements.size() && elements[element].episode != nullptr) return elements[element];
    throw InputError("expected an episode below " + std::to_string(elements.size()) + " that has begun, got " +
                     std::to_string(element));
  }

  void begin(const EpisodeStart& start) {
    const Scenario& scenario = scenarios[start.scenario];
    auto episode =
        std::make_unique<crowd::Episode>(scenario.list().scene(start.seed, start.instance), start.number, vision);
    Element& element = elements[start.element];
    element.senses.emplace(episode->scene());
    element.episode = std::move(episode);
    element.robot = robots[start.scenario][start.instance % scenario.list().size()];
    element.contacts.clear();
    observe(start.element);
  }

  void step(std::size_t i, const double* command, Worker& worker) {
    Element& element = elements[i];
    crowd::Episode& episode = *element.episode;
    element.contacts.clear();
    if (!episode.isOver()) episode.robots().command(element.robot, {{command[0], command[1]}, command[2]});
    for (std::uint32_t tick = 0; tick < options.ticks && !episode.isOver(); ++tick) {
      do {
        episode.walk(worker.decider);
      } while (!episode.beginsTick());
      element.senses->observe(episode.world());
      addContacts(episode.world().robots()[element.robot], element.contacts);
    }
    observe(i);
  }

  /// Writes what the robot of an episode knows.
  void observe(std::size_t i) {
    Element& element = elements[i];
    const World& world = element.episode->world();
    const RobotObservation seen = observeRobot(world.robots()[element.robot], world, element.contacts);
    put(toPublic(seen.pose.position), &arrays.pose[3 * i]);
    arrays.pose[3 * i + 2] = seen.pose.heading;
    put(toPublic(seen.twist.linear), &arrays.twist[3 * i]);
    arrays.twist[3 * i + 2] = seen.twist.rotation;
    put(toPublic(seen.goal), &arrays.goal[2 * i]);
    arrays.remaining_distance[i] = seen.remaining_distance;
    arrays.clearance[i] = seen.clearance;
    arrays.contacts[i] = static_cast<std::uint32_t>(seen.contacts.size());
    arrays.contacts_by_robot[i] = static_cast<std::uint32_t>(seen.by_robot.size());
    arrays.contacts_by_person[i] = static_cast<std::uint32_t>(seen.by_person.size());
    arrays.has_goal[i] = seen.has_goal ? 1 : 0;
    arrays.arrived[i] = seen.arrived ? 1 : 0;
    arrays.blocked[i] = seen.blocked ? 1 : 0;
    arrays.over[i] = element.episode->isOver() ? 1 : 0;
    arrays.tick[i] = world.tick();
    if (options.scan) {
      const std::vector<float>& ranges = element.senses->ranges(world, element.robot);
      std::copy(ranges.begin(), ranges.end(), arrays.scan.begin() + static_cast<std::ptrdiff_t>(i * robot.rays));
    }
    if (options.max_people > 0) observePeople(i);
  }

  void observePeople(std::size_t i) {
    Element& element = elements[i];
    std::vector<crowd::Neighbour> people = visiblePeople(element.episode->world(), element.robot, *element.senses);
    people.resize(std::min<std::size_t>(people.size(), options.max_people));
    arrays.people_count[i] = static_cast<std::uint32_t>(people.size());
    const std::size_t row = options.max_people * RobotArrays::PERSON;
    double* to = &arrays.people[i * row];
    std::fill(to, to + row, 0.0);
    for (const crowd::Neighbour& person : people) {
      put(toPublic(person.position), to);
      put(toPublic(person.velocity), to + 2);
      to[4] = person.radius;
      to += RobotArrays::PERSON;
    }
  }

  std::vector<Scenario> scenarios;
  std::vector<std::vector<RobotId>> robots;  // by scenario and document
  QTable table;
  crowd::Vision vision;
  RobotBatchOptions options;
  RobotDescription robot;
  ThreadPool pool;
  std::vector<std::unique_ptr<Worker>> workers;  // of the pool
  std::vector<Element> elements;
  RobotArrays arrays;
};

RobotBatch::RobotBatch(std::vector<Scenario> scenarios, const QTable& table, const RobotBatchOptions& options)
    : state_(std::make_unique<State>(std::move(scenarios), table, options)) {}
RobotBatch::RobotBatch(RobotBatch&&) noexcept = default;
RobotBatch& RobotBatch::operator=(RobotBatch&&) noexcept = default;
RobotBatch::~RobotBatch() = default;

const RobotDescription& RobotBatch::robot() const { return state_->robot; }
std::size_t RobotBatch::size() const { return state_->elements.size(); }
const RobotArrays& RobotBatch::arrays() const { return state_->arrays; }

void RobotBatch::begin(const std::vector<EpisodeStart>& starts) {
  std::vector<bool> begins(size());
  for (const EpisodeStart& start : starts) {
    if (start.element >= size() || start.scenario >= state_->scenarios.size()) {
      throw InputError("expected an element below " + std::to_string(size()) + " and a scenario below " +
                       std::to_string(state_->scenarios.size()) + ", got " + std::to_string(start.element) + " and " +
                       std::to_string(start.scenario));
    }
    if (begins[start.element])
      throw InputError("element " + std::to_string(start.element) + ": expected once, got twice");
    begins[start.element] = true;
  }
  state_->pool.run(starts.size(), [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) state_->begin(starts[i]);
  });
}

void RobotBatch::step(const std::vector<double>& commands) {
  if (commands.size() != COMMAND * size()) {
    throw InputError("commands: expected " + std::to_string(COMMAND * size()) + " numbers, got " +
                     std::to_string(commands.size()));
  }
  for (std::size_t i = 0; i < size(); ++i) {
    state_->require(i);
    const auto own = commands.begin() + static_cast<std::ptrdiff_t>(COMMAND * i);
    if (!std::all_of(own, own + COMMAND, [](double number) { return std::isfinite(number); })) {
      throw InputError("command of episode " + std::to_string(i) + ": expected finite numbers");
    }
  }
  state_->pool.run(size(), [&](unsigned worker, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) state_->step(i, &commands[COMMAND * i], *state_->workers[worker]);
  });
}

RobotResult RobotBatch::result(std::size_t element) const {
  const State::Element& of = state_->require(element);
  return of.episode->result().robots[of.robot];
}

void RobotBatch::agents(std::size_t element, AgentArrays& arrays) const {
  toPublic(state_->require(element).episode->world(), arrays);
}

std::vector<Wall> RobotBatch::walls(std::size_t element) const {
  std::vector<Wall> walls;
  for (const Segment& wall : state_->require(element).episode->world().walls().list()) walls.push_back(toPublic(wall));
  return walls;
}

}  // namespace crowd::library
