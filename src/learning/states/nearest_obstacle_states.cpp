#include <limits>
#include <utility>

#include "learning/directions.h"
#include "learning/states/row_meaning.h"
#include "learning/states/sector_states.h"
#include "learning/states/sectors.h"

namespace crowd {
namespace {

constexpr int MAX_GOAL_SECTORS = 64;

/// Returns the distance to the nearest rim [m] and a point in its direction, agent frame.
std::pair<double, Vector2> findNearest(const Perception& perception) {
  std::pair<double, Vector2> nearest(std::numeric_limits<double>::infinity(), Vector2::Zero());
  for (const Neighbour& neighbour : perception.neighbours) {
    const double distance = neighbour.position.norm() - neighbour.radius;
    if (distance < nearest.first) nearest = {distance, neighbour.position};
  }
  for (const Segment& wall : perception.walls) {
    const Vector2 point = nearestPoint(wall, Vector2::Zero());
    if (point.norm() < nearest.first) nearest = {point.norm(), point};
  }
  return nearest;
}

/// The thesis's state set 1 (3.2-3.4): sector of the goal, and sector and distance class of the nearest
/// rim of an agent, obstacle or wall.
///
/// With G the goal sector (nG of them), A the obstacle sector (nO), D the distance class (1 .. nD):
/// nothing perceived: G; else (nG - 1) + G * (nO * nD) + A * nD + D; terminal: nG * nO * nD + nG.
class NearestObstacleStates : public SectorStates, public ExplainedRows {
 public:
  static constexpr const char* TYPE = "nearest_obstacle";
  static std::shared_ptr<const StateSet> read(YamlMap& map, const ActionSet& action_set);

  struct Parameters {
    int goal_sectors = 8;
    std::vector<double> obstacle_sectors = {15, 45, 90, 180};  ///< outer limits to either side [degrees]
    DistanceClasses distances;
    Directions directions = Directions::RELATIVE;
  };

  explicit NearestObstacleStates(const Parameters& parameters);

  void findRows(const PerceptionBatch& batch, const MoveBlock* moves, Row* rows) const override;
  Row mirrored(Row row) const override;
  std::vector<int> distanceClasses(Row row) const override;
  std::vector<OccupiedSector> occupiedSectors(const Perception& perception) const override;
  std::string spec() const override;
  RowMeaning meaning() const override;
  Row terminal() const override;  // (3.4)

 private:
  /// The contents of a state.
  struct Situation {
    int goal_sector = 0;
    int obstacle_sector = 0;
    int distance_class = 0;  ///< 0: nothing perceived
  };

  /// Returns the contents of the state that a perception maps to.
  Situation describe(const Perception& perception) const;
  /// Returns the row of a situation, (3.2) and (3.3).
  Row rowOf(const Situation& situation) const;
  /// Inverse of rowOf(). @param row not the terminal row
  Situation situationOf(Row row) const;
  /// Returns the angle between the x axis of the agent's frame and the direction that sectors are relative to [rad].
  double frameAngle(const Perception& perception) const {
    return directions_ == Directions::ABSOLUTE ? perception.self.pose.heading : 0.0;
  }

  EvenSectors goal_sectors_;
  MirroredSectors obstacle_sectors_;
  Directions directions_;
};

NearestObstacleStates::NearestObstacleStates(const Parameters& parameters)
    : SectorStates(parameters.distances),
      goal_sectors_(parameters.goal_sectors),
      obstacle_sectors_(parameters.obstacle_sectors),
      directions_(parameters.directions) {}

void NearestObstacleStates::findRows(const PerceptionBatch& batch, const MoveBlock* /*moves*/, Row* rows) const {
  for (const Perception& seen : batch) *rows++ = rowOf(describe(seen));
}

NearestObstacleStates::Situation NearestObstacleStates::describe(const Perception& perception) const {
  Situation situation;
  const double frame = frameAngle(perception);
  situation.goal_sector = goal_sectors_.indexOf(bearingOf(perception.self.goal) + frame);
  const auto [distance, where] = findNearest(perception);
  situation.distance_class = distances().classOf(distance);
  if (situation.distance_class == 0) return situation;
  // wrapAngle() would make -pi of pi, which is on the other side.
  const double bearing = bearingOf(where);
  situation.obstacle_sector = obstacle_sectors_.indexOf(frame == 0.0 ? bearing : wrapAngle(bearing + frame));
  return situation;
}

Row NearestObstacleStates::rowOf(const Situation& situation) const {
  if (situation.distance_class == 0) return static_cast<Row>(situation.goal_sector);  // (3.2)
  const int obstacle_states = obstacle_sectors_.count() * DistanceClasses::COUNT;
  return static_cast<Row>((goal_sectors_.count() - 1) + situation.goal_sector * obstacle_states +
                          situation.obstacle_sector * DistanceClasses::COUNT + situation.distance_class);  // (3.3)
}

Row NearestObstacleStates::terminal() const {
  const int obstacle_states = obstacle_sectors_.count() * DistanceClasses::COUNT;
  return static_cast<Row>(goal_sectors_.count() * obstacle_states + goal_sectors_.count());  // (3.4)
}

NearestObstacleStates::Situation NearestObstacleStates::situationOf(Row row) const {
  const int code = static_cast<int>(row) - goal_sectors_.count();
  if (code < 0) return {static_cast<int>(row), 0, 0};
  const int obstacle_states = obstacle_sectors_.count() * DistanceClasses::COUNT;
  return {code / obstacle_states, code % obstacle_states / DistanceClasses::COUNT, code % DistanceClasses::COUNT + 1};
}

Row NearestObstacleStates::mirrored(Row row) const {
  if (row >= terminal()) return row;
  Situation situation = situationOf(row);
  situation.goal_sector = goal_sectors_.mirrored(situation.goal_sector);
  situation.obstacle_sector = obstacle_sectors_.mirrored(situation.obstacle_sector);
  return rowOf(situation);
}

std::vector<int> NearestObstacleStates::distanceClasses(Row row) const {
  if (row >= terminal()) return {};
  const int distance_class = situationOf(row).distance_class;
  return distance_class > 0 ? std::vector<int>{distance_class} : std::vector<int>();
}

std::vector<OccupiedSector> NearestObstacleStates::occupiedSectors(const Perception& perception) const {
  const Situation situation = describe(perception);
  if (situation.distance_class == 0) return {};
  const double frame = frameAngle(perception);
  return {{obstacle_sectors_.rightLimit(situation.obstacle_sector) - frame,
           obstacle_sectors_.leftLimit(situation.obstacle_sector) - frame, situation.distance_class}};
}

std::string NearestObstacleStates::spec() const {
  return std::string("{type: ") + TYPE + ", goal_sectors: " + std::to_string(goal_sectors_.count()) + ", " +
         sectorLimitsSpec(obstacle_sectors_.degrees()) + distancesSpec() +
         (directions_ == Directions::ABSOLUTE ? ", directions: absolute}" : "}");
}

RowMeaning NearestObstacleStates::meaning() const {
  RowQuantity obstacle{"nearest obstacle", {"none"}};
  for (const std::string& sector : namesOf(obstacle_sectors_)) {
    for (const std::string& distance : namesOf(distances())) {
      obstacle.classes.push_back(sector + ", ");
      obstacle.classes.back() += distance;
    }
  }
  RowMeaning meaning{{{"goal", namesOf(goal_sectors_)}, std::move(obstacle)}, {}, true};
  for (Row row = 0; row < terminal(); ++row) {
    const Situation situation = situationOf(row);
    const int number = situation.obstacle_sector * DistanceClasses::COUNT + situation.distance_class;
    meaning.rows.push_back({situation.goal_sector, number});
  }
  return meaning;
}

std::shared_ptr<const StateSet> NearestObstacleStates::read(YamlMap& map, const ActionSet& /*action_set*/) {
  map.allow({"type", "goal_sectors", "obstacle_sectors", "collision_radius", "vision_radius", "directions"});
  Parameters parameters;
  parameters.goal_sectors = static_cast<int>(map.whole("goal_sectors", 1, MAX_GOAL_SECTORS, parameters.goal_sectors));
  parameters.obstacle_sectors = readSectorLimits(map, parameters.obstacle_sectors);
  parameters.distances = readDistanceClasses(map);
  parameters.directions = DIRECTIONS.read(map, parameters.directions);
  return std::make_shared<NearestObstacleStates>(parameters);
}

}  // namespace

StateSetType nearestObstacleStates() {
  return {NearestObstacleStates::TYPE, "thesis set 1: goal sector; sector and distance class of the nearest obstacle",
          NearestObstacleStates::read};
}

}  // namespace crowd
