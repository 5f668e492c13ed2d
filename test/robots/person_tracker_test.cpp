#include "robots/person_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "robots/robot_senses.h"
#include "support/robots.h"
#include "support/scenes.h"

namespace crowd::person_tracker_test {
namespace {

constexpr RobotId ROBOT = 0;
constexpr int TICKS = 400;
const std::vector<AgentAction> AHEAD = {{0, {0.0, 1.0}}};

/// Ticks of 0.5 s, a robot at the origin, and a person 2 m ahead who walks away from it at 1 m/s.
Scene sceneOf(const TrackSpec& tracks) {
  Scene scene = robots::with({robots::robot({0.0, 0.0})},
                             scenes::halfSeconds(scenes::scene({scenes::wanderer({2.0, 0.0}, 1.0)})));
  scene.robots[0].tracks = tracks;
  scene.robots[0].scan.rays = 360;
  return scene;
}

/// The same with 50 people in a row who stand.
Scene crowdOf(const TrackSpec& tracks) {
  Scene scene = sceneOf(tracks);
  scene.agents.clear();
  for (int i = 0; i < 50; ++i) scene.agents.push_back(scenes::wanderer({i - 25.0, 3.0}));
  return scene;
}

std::vector<PersonTrack> tracksOf(const Scene& scene) { return RobotSenses(scene).tracks(World(scene), ROBOT); }

/// The tracks of each tick; nobody moves.
std::vector<std::vector<PersonTrack>> tracksOfTicks(const Scene& scene, int ticks) {
  World world(scene);
  RobotSenses senses(scene);
  std::vector<std::vector<PersonTrack>> tracks;
  for (int tick = 0; tick < ticks; ++tick) {
    tracks.push_back(senses.tracks(world, ROBOT));
    world.step({});
  }
  return tracks;
}

/// Numbers of all tracks, exactly.
std::vector<double> numbersOf(const std::vector<PersonTrack>& tracks) {
  std::vector<double> numbers;
  for (const PersonTrack& track : tracks) {
    for (const double number :
         {static_cast<double>(track.id), track.pose.position.x(), track.pose.position.y(), track.pose.heading,
          track.velocity.x(), track.velocity.y(), track.position_variance, track.age, track.reliability}) {
      numbers.push_back(number);
    }
  }
  return numbers;
}

/// A tracker of a person who walks ahead and is visible in some ticks.
class Hidden {
 public:
  explicit Hidden(const TrackSpec& spec)
      : world_(sceneOf(spec)), tracker_(spec, KeyedRandom(1, KeyedRandom::TRACKS, {0}), 10.0) {}

  /// The tracks after the next tick.
  std::vector<PersonTrack> walk(bool is_visible) {
    world_.step(AHEAD);
    const std::vector<bool> visible = {is_visible};
    TrackerView view;
    view.visible = &visible;
    return tracker_.update(world_, view, nullptr);
  }

 private:
  World world_;
  PersonTracker tracker_;
};

TEST(PersonTracker, ReportsTheTruthByDefault) {
  Scene scene = sceneOf({});
  scene.walls = {{{1.0, -4.0}, {1.0, 4.0}}};  // hides nobody
  scene.obstacles = {scenes::pillar({-5.0, 0.0}, 0.5)};
  const auto recorded = std::make_shared<const Track>(Track({0.0, 1.0}, {{0.0, 3.0}, {1.0, 3.0}}));
  scene.obstacles.push_back({ObstaclePath::recorded(recorded), 0.25, 12});
  World world(scene);
  world.step(AHEAD);
  RobotSenses senses(scene);
  const std::vector<PersonTrack>& tracks = senses.tracks(world, ROBOT);
  ASSERT_EQ(tracks.size(), 2U);
  EXPECT_EQ(tracks[0].id, 0U);
  EXPECT_EQ(tracks[0].name, "0");
  EXPECT_EQ(tracks[0].pose.position, Vector2(2.5, 0.0));
  EXPECT_EQ(tracks[0].pose.heading, world.agents()[0].pose.heading);
  EXPECT_EQ(tracks[0].velocity, Vector2(1.0, 0.0));
  EXPECT_EQ(tracks[0].position_variance, 0.0);
  EXPECT_EQ(tracks[0].age, 0.5);
  EXPECT_EQ(tracks[0].reliability, 1.0);
  EXPECT_TRUE(tracks[0].detected);
  EXPECT_EQ(tracks[1].name, "recorded person 12");
  EXPECT_EQ(tracks[1].pose.position, Vector2(0.5, 3.0));
}

TEST(PersonTracker, DoesNotSeePeopleBehindAWall) {
  TrackSpec spec;
  Scene scene = sceneOf(spec);
  scene.walls = {{{1.0, -4.0}, {1.0, 4.0}}};
  EXPECT_EQ(tracksOf(scene).size(), 1U);
  EXPECT_EQ(RobotSenses(scene, true).tracks(World(scene), ROBOT).size(), 0U);
  scene.robots[ROBOT].tracks.occlusion = true;
  EXPECT_EQ(tracksOf(scene).size(), 0U);
  // Around its end a part of the body is in sight.
  scene.walls = {{{1.0, -4.0}, {1.0, 0.05}}};
  EXPECT_EQ(tracksOf(scene).size(), 1U);
}

TEST(PersonTracker, HasARangeFromTheScanner) {
  TrackSpec spec;
  spec.range = 2.0;
  Scene scene = sceneOf(spec);
  EXPECT_EQ(tracksOf(scene).size(), 1U);
  scene.robots[ROBOT].scan.mount.position = {-0.1, 0.0};
  EXPECT_EQ(tracksOf(scene).size(), 0U);
}

TEST(PersonTracker, PredictsThoseItDoesNotDetect) {
  TrackSpec spec;
  spec.keep = 1.0;  // two ticks
  Hidden hidden(spec);
  EXPECT_EQ(hidden.walk(true).at(0).age, 0.0);
  EXPECT_EQ(hidden.walk(true).at(0).age, 0.5);  // at 3 m
  std::vector<PersonTrack> tracks = hidden.walk(false);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_FALSE(tracks[0].detected);
  EXPECT_EQ(tracks[0].pose.position, Vector2(3.5, 0.0));
  EXPECT_EQ(tracks[0].age, 1.0);
  EXPECT_NEAR(tracks[0].reliability, 1.0 - 0.5 / 1.5, 1e-12);
  tracks = hidden.walk(false);
  EXPECT_EQ(tracks.at(0).pose.position, Vector2(4.0, 0.0));
  EXPECT_NEAR(tracks[0].reliability, 1.0 - 1.0 / 1.5, 1e-12);
  EXPECT_EQ(tracks[0].id, 0U);
  // Within the time the track goes on.
  tracks = hidden.walk(true);
  EXPECT_EQ(tracks.at(0).id, 0U);
  EXPECT_TRUE(tracks[0].detected);
  EXPECT_EQ(tracks[0].reliability, 1.0);
  EXPECT_EQ(tracks[0].age, 2.0);
}

TEST(PersonTracker, ForgetsATrackAfterAWhile) {
  for (const double keep : {0.0, 1.0}) {
    TrackSpec spec;
    spec.keep = keep;
    Hidden hidden(spec);
    EXPECT_EQ(hidden.walk(true).at(0).id, 0U);
    for (int tick = 0; tick < 2 * keep; ++tick) EXPECT_EQ(hidden.walk(false).size(), 1U);
    EXPECT_EQ(hidden.walk(false).size(), 0U);
    const PersonTrack again = hidden.walk(true).at(0);
    EXPECT_EQ(again.id, 1U);
    EXPECT_EQ(again.name, "1");
    EXPECT_EQ(again.age, 0.0);
  }
}

TEST(PersonTracker, WithoutMemoryKnowsEverybody) {
  Hidden hidden(TrackSpec{});
  EXPECT_EQ(hidden.walk(true).at(0).id, 0U);
  for (int tick = 0; tick < 10; ++tick) EXPECT_EQ(hidden.walk(false).size(), 0U);
  EXPECT_EQ(hidden.walk(true).at(0).id, 0U);
}

TEST(PersonTracker, PredictionsAreLessCertain) {
  TrackSpec spec;
  spec.keep = 1.0;
  spec.noise = 0.1;
  spec.velocity_noise = 0.2;
  Hidden hidden(spec);
  EXPECT_NEAR(hidden.walk(true).at(0).position_variance, 0.01, 1e-12);
  hidden.walk(false);
  const PersonTrack track = hidden.walk(false).at(0);
  EXPECT_NEAR(track.position_variance, 0.01 + 0.04 * 1.0, 1e-12);
  EXPECT_NEAR(track.velocity_variance, 0.04, 1e-12);
}

TEST(PersonTracker, MissesPeopleAsOftenAsWanted) {
  TrackSpec spec;
  spec.missed = 0.1;
  std::size_t missed = 0;
  for (const auto& tracks : tracksOfTicks(crowdOf(spec), TICKS)) missed += 50 - tracks.size();
  // Of 20,000 detections 2000 are missed; the standard deviation is sqrt(20,000 0.1 0.9) = 42.
  EXPECT_NEAR(static_cast<double>(missed), 2000.0, 5.0 * 42.5);
}

TEST(PersonTracker, NoiseHasItsDeviation) {
  TrackSpec spec;
  spec.noise = 0.05;
  spec.velocity_noise = 0.2;
  const Scene scene = crowdOf(spec);
  double sum = 0.0;
  double squares = 0.0;
  double velocity_squares = 0.0;
  for (const auto& tracks : tracksOfTicks(scene, TICKS)) {
    ASSERT_EQ(tracks.size(), scene.agents.size());
    for (const PersonTrack& track : tracks) {
      const Vector2 error = track.pose.position - scene.agents[track.id].position;
      sum += error.sum();
      squares += error.squaredNorm();
      velocity_squares += track.velocity.squaredNorm();
      EXPECT_EQ(track.pose.heading, bearingOf(track.velocity));
    }
  }
  // 40,000 numbers each: the mean deviates by 0.05 / 200, variances by their share sqrt(2 / 40,000) = 0.0071.
  const double count = 2.0 * 50.0 * TICKS;
  EXPECT_NEAR(sum / count, 0.0, 5.0 * 0.05 / 200.0);
  EXPECT_NEAR(squares / count / (0.05 * 0.05), 1.0, 5.0 * 0.0071);
  EXPECT_NEAR(velocity_squares / count / (0.2 * 0.2), 1.0, 5.0 * 0.0071);
}

TEST(PersonTracker, DetectsNobodyAsOftenAsWanted) {
  TrackSpec spec;
  spec.false_detections = 4.0;  // 2 in a tick
  spec.range = 1.9;             // nobody is as near as that
  std::size_t count = 0;
  for (const auto& tracks : tracksOfTicks(sceneOf(spec), TICKS)) count += tracks.size();
  EXPECT_NEAR(static_cast<double>(count), 2.0 * TICKS, 5.0 * std::sqrt(2.0 * TICKS));
}

TEST(PersonTracker, DetectsNobodyInFreePlacesInSight) {
  TrackSpec spec;
  spec.false_detections = 20.0;
  Scene scene = sceneOf(spec);
  scene.robots[ROBOT].scan.max_range = 5.0;
  scene.walls = {{{1.0, -9.0}, {1.0, 9.0}}};
  scene.obstacles = {scenes::pillar({-2.0, 0.0}, 0.5)};
  for (const bool occlusion : {false, true}) {
    scene.robots[ROBOT].tracks.occlusion = occlusion;
    bool is_any_beyond = false;
    for (const auto& tracks : tracksOfTicks(scene, TICKS)) {
      for (const PersonTrack& track : tracks) {
        if (track.id == 0) continue;  // the person
        const Vector2& place = track.pose.position;
        EXPECT_LE(place.norm(), 5.0);
        EXPECT_GE(place.norm(), 0.3 + 0.25 - 1e-3);                         // beside the robot
        EXPECT_GE((place - Vector2(-2.0, 0.0)).norm(), 0.5 + 0.25 - 1e-3);  // beside the pillar
        EXPECT_GE(std::abs(place.x() - 1.0), 0.25 - 1e-3);                  // beside the wall
        is_any_beyond = is_any_beyond || place.x() > 1.0;
        if (!occlusion || std::abs(place.y()) > 0.2) continue;
        EXPECT_GT(place.x(), -2.0);  // behind the pillar it sees nothing
      }
    }
    EXPECT_EQ(is_any_beyond, !occlusion);
  }
}

TEST(PersonTracker, DetectsNobodyOnCellsThatAreNotFree) {
  TrackSpec spec;
  spec.false_detections = 20.0;
  OccupancyMap map;
  map.resolution = 1.0;
  map.origin.position = {-4.0, -4.0};
  map.width = 8;
  map.height = 8;
  map.cells.assign(64, CellState::FREE);
  for (std::size_t i = 0; i < 32; ++i) map.cells[i] = CellState::UNKNOWN;  // south of the robot
  Scene scene = sceneOf(spec);
  scene.map = std::make_shared<const OccupancyMap>(map);
  scene.robots[ROBOT].scan.max_range = 4.0;
  for (const auto& tracks : tracksOfTicks(scene, 50)) {
    EXPECT_GT(tracks.size(), 1U);
    for (const PersonTrack& track : tracks) EXPECT_GE(track.pose.position.y(), 0.0);
  }
}

TEST(PersonTracker, DetectionsOfNobodyAreTracksOfTheirOwn) {
  TrackSpec spec;
  spec.false_detections = 2.0;
  spec.range = 1.9;
  spec.keep = 0.5;  // a tick
  std::uint64_t next = 0;
  std::size_t predicted = 0;
  std::vector<PersonTrack> before;
  for (const auto& tracks : tracksOfTicks(sceneOf(spec), TICKS)) {
    std::size_t detected = 0;
    for (const PersonTrack& track : before) detected += track.detected ? 1 : 0;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      EXPECT_EQ(tracks[i].detected, i >= detected);  // the older ones come first
      if (tracks[i].detected) EXPECT_EQ(tracks[i].id, next++);
      predicted += tracks[i].detected ? 0 : 1;
    }
    before = tracks;
  }
  EXPECT_GT(predicted, 100U);
}

TEST(PersonTracker, DependsOnTheSeedAndTheTickOnly) {
  TrackSpec spec;
  spec.occlusion = true;
  spec.noise = 0.1;
  spec.velocity_noise = 0.1;
  spec.missed = 0.2;
  spec.false_detections = 1.0;
  for (const std::optional<double>& keep : {std::optional<double>(), std::optional<double>(1.0)}) {
    spec.keep = keep;
    Scene scene = crowdOf(spec);
    const auto tracks = tracksOfTicks(scene, 20);
    const auto again = tracksOfTicks(scene, 20);
    for (std::size_t i = 0; i < tracks.size(); ++i) EXPECT_EQ(numbersOf(tracks[i]), numbersOf(again[i]));
    if (!keep) {
      World world(scene);
      for (int tick = 0; tick < 19; ++tick) world.step({});
      RobotSenses late(scene);
      EXPECT_EQ(numbersOf(tracks.back()), numbersOf(late.tracks(world, ROBOT)));
    }
    scene.population_seed = 9;
    EXPECT_NE(numbersOf(tracks.back()), numbersOf(tracksOfTicks(scene, 20).back()));
  }
}

TEST(PersonTracker, OfEachRobotHasItsOwnErrors) {
  TrackSpec spec;
  spec.noise = 0.1;
  Scene scene = crowdOf(spec);
  scene.robots.push_back(scene.robots[0]);
  scene.robots[1].position = {0.0, -2.0};
  const World world(scene);
  RobotSenses senses(scene);
  const std::vector<double> second = numbersOf(senses.tracks(world, 1));
  EXPECT_NE(numbersOf(senses.tracks(world, 0)), second);
  // It keeps them when the first one is removed.
  Scene rest = scene;
  rest.robots.erase(rest.robots.begin());
  RobotSenses less(scene);
  less.remove(0);
  EXPECT_EQ(numbersOf(less.tracks(World(rest), 0)), second);
}

TEST(PersonTracker, ChangesNothingInTheWorld) {
  TrackSpec spec;
  spec.occlusion = true;
  spec.false_detections = 5.0;
  spec.keep = 1.0;
  World tracked(sceneOf(spec));
  RobotSenses senses(sceneOf(spec));
  World alone(sceneOf({}));
  for (int tick = 0; tick < 20; ++tick) {
    senses.tracks(tracked, ROBOT);
    for (World* world : {&tracked, &alone}) world->step({{0, {0.3, 0.7}}});
    EXPECT_EQ(tracked.agents()[0].pose.position, alone.agents()[0].pose.position);
    EXPECT_EQ(tracked.agents()[0].pose.heading, alone.agents()[0].pose.heading);
  }
}

}  // namespace
}  // namespace crowd::person_tracker_test
