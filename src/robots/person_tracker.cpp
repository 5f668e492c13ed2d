#include "robots/person_tracker.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "common/portable_math.h"

namespace crowd {
namespace {

// Keys of false detections: this one, the tick times FALSE_OF_A_TICK, and a number. They are below 2^53.
constexpr std::uint64_t FALSE_KEY = 1ULL << 52U;
constexpr std::uint64_t FALSE_OF_A_TICK = 1ULL << 20U;

constexpr double FALSE_RADIUS = 0.25;   // free room around a false detection [m]: that of a person
constexpr int PLACE_DRAWS = 30;         // for a false detection; then it is left out
constexpr double TICK_ROUNDING = 1e-9;  // of a number of ticks

/// The number of events of a Poisson process in a time in which `mean` are expected.
std::uint64_t drawCount(KeyedRandom& random, double mean) {
  std::uint64_t count = 0;
  for (double time = -portable::log(1.0 - random.uniform()); time < mean; time -= portable::log(1.0 - random.uniform()))
    ++count;
  return count;
}

/// A place in a disc, all with the same probability.
Vector2 drawPlace(KeyedRandom& random, const Vector2& centre, double radius) {
  const double distance = radius * std::sqrt(random.uniform());
  return centre + distance * unitVector(random.uniform(-PI, PI));
}

bool isFree(const Vector2& place, const World& world, const OccupancyMap* map) {
  if (map != nullptr && !map->isFree(CellFrame(*map).cellAt(place))) return false;
  return world.blockerAt(place, FALSE_RADIUS).empty();
}

}  // namespace

PersonTracker::PersonTracker(const TrackSpec& spec, const KeyedRandom& key, double false_range)
    : spec_(spec), key_(key), false_range_(false_range) {}

std::vector<PersonTrack> PersonTracker::update(const World& world, const TrackerView& view, const OccupancyMap* map) {
  detections_.clear();
  detectAll(world, view);
  if (spec_.false_detections > 0.0) addFalseDetections(world, view, map);
  if (spec_.keep) return follow(world.tick(), world.tickDuration());
  std::vector<PersonTrack> tracks;
  for (auto& [key, track] : detections_) tracks.push_back(std::move(track));
  return tracks;
}

void PersonTracker::detectAll(const World& world, const TrackerView& view) {
  const auto is_visible = [&](std::size_t body) { return view.visible == nullptr || (*view.visible)[body]; };
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    if (!agent.isPresent() || !is_visible(i)) continue;
    detect(agent.id, {agent.id, std::to_string(agent.id), agent.pose, agent.velocity}, world, view);
  }
  for (std::size_t i = 0; i < world.obstacles().size(); ++i) {
    const Obstacle& obstacle = world.obstacles()[i];
    if (!obstacle.person || !world.isPresent(obstacle) || !is_visible(world.agents().size() + i)) continue;
    const PathMotion motion = obstacle.path.at(world.time());
    const Pose pose{motion.position, bearingOf(motion.velocity)};
    const AgentId id = idOfRecorded(i);
    detect(id, {id, nameOf(obstacle, i), pose, motion.velocity}, world, view);
  }
}

void PersonTracker::detect(Key key, PersonTrack truth, const World& world, const TrackerView& view) {
  if ((truth.pose.position - view.sensor).norm() > spec_.range) return;
  KeyedRandom random = key_.with(world.tick()).with(key);
  if (spec_.missed > 0.0 && random.uniform() < spec_.missed) return;
  truth.age = world.time();
  addErrors(random, truth);
  detections_.emplace(key, std::move(truth));
}

void PersonTracker::addErrors(KeyedRandom& random, PersonTrack& track) const {
  track.position_variance = spec_.noise * spec_.noise;
  track.velocity_variance = spec_.velocity_noise * spec_.velocity_noise;
  const auto add = [&random](double deviation, Vector2& vector) {
    if (deviation <= 0.0) return;
    vector.x() += deviation * random.normal();
    vector.y() += deviation * random.normal();
  };
  add(spec_.noise, track.pose.position);
  add(spec_.velocity_noise, track.velocity);
  if (spec_.velocity_noise > 0.0) track.pose.heading = bearingOf(track.velocity);
}

void PersonTracker::addFalseDetections(const World& world, const TrackerView& view, const OccupancyMap* map) {
  KeyedRandom random = key_.with(world.tick()).with(FALSE_KEY);
  const auto draw = [&]() -> std::optional<Vector2> {
    for (int i = 0; i < PLACE_DRAWS; ++i) {
      const Vector2 place = drawPlace(random, view.sensor, false_range_);
      if (view.scanner != nullptr && !view.scanner->reaches(place)) continue;
      if (isFree(place, world, map)) return place;
    }
    return std::nullopt;
  };
  const std::uint64_t count = drawCount(random, spec_.false_detections * world.tickDuration());
  for (std::uint64_t i = 0; i < std::min(count, FALSE_OF_A_TICK); ++i) {
    const std::optional<Vector2> place = draw();
    if (!place) continue;
    const Key key = FALSE_KEY + world.tick() * FALSE_OF_A_TICK + i;
    PersonTrack track{key, std::to_string(key), {*place, 0.0}};
    addErrors(random, track);
    detections_.emplace(key, std::move(track));
  }
}

std::vector<PersonTrack> PersonTracker::follow(std::uint64_t tick, double tick_duration) {
  for (auto& [key, track] : detections_) {
    const auto [kept, is_new] = kept_.try_emplace(key);
    if (is_new) {
      kept->second.since = tick;
      kept->second.last.id = next_id_++;
    }
    track.id = kept->second.last.id;
    track.name = std::to_string(track.id);
    track.age = static_cast<double>(tick - kept->second.since) * tick_duration;
    kept->second.last = std::move(track);
    kept->second.detected = tick;
  }
  std::vector<PersonTrack> tracks;
  for (auto kept = kept_.begin(); kept != kept_.end();) {
    const auto ticks = static_cast<double>(tick - kept->second.detected);
    if (ticks > *spec_.keep / tick_duration + TICK_ROUNDING) {
      kept = kept_.erase(kept);
    } else {
      tracks.push_back(predicted(kept->second, ticks, tick_duration));
      ++kept;
    }
  }
  std::sort(tracks.begin(), tracks.end(), [](const PersonTrack& a, const PersonTrack& b) { return a.id < b.id; });
  return tracks;
}

PersonTrack PersonTracker::predicted(const Kept& kept, double ticks, double tick_duration) const {
  PersonTrack track = kept.last;
  const double time = ticks * tick_duration;
  track.detected = ticks <= 0.0;
  track.pose.position += time * track.velocity;
  track.position_variance += track.velocity_variance * time * time;
  track.age += time;
  track.reliability = 1.0 - ticks / (*spec_.keep / tick_duration + 1.0);
  return track;
}

}  // namespace crowd
