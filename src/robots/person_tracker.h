#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/random.h"
#include "maps/occupancy_map.h"
#include "robots/scanner.h"
#include "scenario/robot_sensors.h"
#include "world/world.h"

namespace crowd {

/// @brief A person as a tracker on a robot reports it, in `map`.
struct PersonTrack {
  std::uint64_t id = 0;
  std::string name;                    ///< the id, or the name of a recorded person
  Pose pose;                           ///< with a noise of the velocity, the heading is that of the velocity
  Vector2 velocity = Vector2::Zero();  ///< [m/s]
  double position_variance = 0.0;      ///< of x and of y [m^2]
  double velocity_variance = 0.0;      ///< of both components [m^2/s^2]
  double age = 0.0;                    ///< since its first detection; without `keep` since the start of the episode [s]
  bool detected = true;                ///< in this tick; else it is predicted
  double reliability = 1.0;            ///< falls with the time of the prediction
};

/// @brief What a tracker's sensor sees in a tick.
struct TrackerView {
  Vector2 sensor = Vector2::Zero();            ///< its place [m], `map`
  const Scanner* scanner = nullptr;            ///< has scanned in this tick; null: nothing hides anybody
  const std::vector<bool>* visible = nullptr;  ///< agents by position, then obstacles; null: all
};

/// @brief Tracks of the people around a robot, as a tracker on it reports them: with ids, errors, people who are
/// missed, and false detections (TrackSpec). All depends on the random numbers' key, the tick and the person only.
/// It never changes the world. Not thread-safe.
///
/// Without `keep` the id of an agent is its number, and a track ends with its detection. With it, tracks are numbered
/// from 0 in the order of their first detections. A track that is not detected is predicted, at its last velocity, for
/// at most this time; then it is forgotten.
class PersonTracker {
 public:
  /// @param key of its random numbers @param false_range greatest distance of false detections [m]
  PersonTracker(const TrackSpec& spec, const KeyedRandom& key, double false_range);

  const TrackSpec& spec() const { return spec_; }
  /// @brief The tracks after this tick, by ascending id. Called at most once in a tick; with `keep` in each, as it
  /// otherwise takes people for missed. @param map whose free cells people stand on; null: none
  std::vector<PersonTrack> update(const World& world, const TrackerView& view, const OccupancyMap* map);

 private:
  /// Numbers of those whom a tracker may detect: agents have their ids, recorded people idOfRecorded().
  using Key = std::uint64_t;
  struct Kept {
    PersonTrack last;            // detection
    std::uint64_t since = 0;     // tick of the first one
    std::uint64_t detected = 0;  // tick of the last one
  };

  void detectAll(const World& world, const TrackerView& view);
  /// Adds a person's track, unless the person is missed or too far away.
  void detect(Key key, PersonTrack truth, const World& world, const TrackerView& view);
  void addFalseDetections(const World& world, const TrackerView& view, const OccupancyMap* map);
  void addErrors(KeyedRandom& random, PersonTrack& track) const;
  std::vector<PersonTrack> follow(std::uint64_t tick, double tick_duration);
  PersonTrack predicted(const Kept& kept, double ticks, double tick_duration) const;

  TrackSpec spec_;
  KeyedRandom key_;
  double false_range_;
  std::map<Key, PersonTrack> detections_;  // of this tick
  std::map<Key, Kept> kept_;
  std::uint64_t next_id_ = 0;
};

}  // namespace crowd
