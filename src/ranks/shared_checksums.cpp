// Checksums by which ranks find that they compute different things.

#include "common/files/checksum.h"
#include "common/files/files.h"
#include "common/files/library_file.h"
#include "ranks/distributed_evaluation.h"
#include "simulation/byte_archive.h"

namespace crowd {
namespace {

/// Adds numbers to a checksum, as an archive of byte_archive.h.
class ChecksumWriter {
 public:
  template <typename Value>
  void operator()(const Value& value) {
    bytes_.clear();
    ByteWriter write(bytes_);
    write(value);
    checksum_.add({bytes_.data(), bytes_.size()});
  }
  std::string text() const { return checksum_.text(); }

 private:
  Checksum checksum_;
  std::vector<char> bytes_;
};

}  // namespace

std::string checksumOf(const Scene& scene) {
  ChecksumWriter write;
  write(scene.tick_duration);
  write(scene.max_ticks);
  write(scene.goal_tolerance);
  write(scene.collision_radius);
  write(scene.contact);
  const MotionLimits motion = scene.motion.value_or(MotionLimits());
  write(scene.motion.has_value());
  write(motion.acceleration);
  write(motion.braking);
  write(motion.turn_rate);
  write(static_cast<std::uint64_t>(scene.agents.size()));
  for (const AgentStart& start : scene.agents) {
    write(start.position);
    write(start.heading);
    write(start.goals);
    write(start.max_speed);
    write(start.hurry);
    write(start.radius);
    write(start.velocity);
    write(start.group);
    write(start.kind);
    write(start.figure);
    write(start.reaction);
    write(start.leaves);
    write(start.stays);
  }
  for (const Obstacle& obstacle : scene.obstacles) {
    write(obstacle.path.points());
    if (const Track* track = obstacle.path.track()) {
      for (const double time : track->times()) write(time);
    }
    write(obstacle.path.velocity(0.0));
    write(obstacle.path.speed());
    write(obstacle.path.kind());
    write(obstacle.radius);
  }
  for (const Segment& wall : scene.walls) {
    write(wall.from);
    write(wall.to);
  }
  return write.text();
}

std::string checksumOfLibrary() {
  const std::string file = libraryFile();
  if (file.empty()) return "unknown";
  Checksum checksum;
  checksum.add(readFile(file));
  return checksum.text();
}

}  // namespace crowd
