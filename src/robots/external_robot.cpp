#include "robots/external_robot.h"

#include <algorithm>
#include <cmath>

#include "geometry/limits.h"

namespace crowd {
namespace {

bool isPlace(const Vector2& position) {
  const double farthest = position.cwiseAbs().maxCoeff();
  return position.allFinite() && farthest <= limits::PLACE.most;
}

}  // namespace

void ExternalRobot::begin(double max_speed, double tick_duration) {
  max_speed_ = max_speed;
  tick_duration_ = tick_duration;
  began_.reset();
  jumped_ = true;
  stale_ = false;
  counts_ = PoseCounts();
}

std::optional<PoseProblem> ExternalRobot::take(const Pose& pose, double stamp) {
  if (!isPlace(pose.position) || !std::isfinite(pose.heading) || !std::isfinite(stamp)) {
    ++counts_.not_finite;
    return PoseProblem::NOT_FINITE;
  }
  if (stamp_ && stamp == *stamp_) return std::nullopt;
  if (stamp_ && stamp < *stamp_ && asked_ && *stamp_ > *asked_ + MAX_GAP) {  // its stamp is of another clock
    stamp_.reset();
    jumped_ = true;
  }
  if (stamp_ && stamp < *stamp_) {
    ++counts_.backwards;
    return PoseProblem::BACKWARDS;
  }
  std::optional<PoseProblem> problem;
  velocity_ = Vector2::Zero();
  if (stamp_) {
    const double passed = stamp - *stamp_;
    const Vector2 way = pose.position - pose_.position;
    const bool is_jump = way.norm() > JUMP_SPEED * max_speed_ * passed + JUMP_TOLERANCE;
    if (is_jump) {
      ++counts_.jumps;
      jumped_ = true;
      problem = PoseProblem::JUMP;
    } else if (passed > MAX_GAP) {
      ++counts_.gaps;
      jumped_ = true;  // it is not known where it was in between
      problem = PoseProblem::GAP;
    } else {
      // Two stamps may be so close that the tolerance makes any speed of it.
      const Vector2 most = Vector2::Constant(limits::VELOCITY.most);
      velocity_ = way / std::max(passed, way.norm() / (JUMP_SPEED * max_speed_));
      velocity_ = velocity_.cwiseMin(most).cwiseMax(-most);
    }
  }
  ++counts_.taken;
  pose_ = {pose.position, wrapAngle(pose.heading)};
  stamp_ = stamp;
  return problem;
}

std::optional<ExternalRobot::State> ExternalRobot::at(double time) {
  if (!began_) began_ = time;
  asked_ = time;
  const double age = time - stamp_.value_or(*began_);
  const bool was_stale = stale_;
  stale_ = std::abs(age) > MAX_GAP;
  if (stale_ && !was_stale) ++counts_.stale;
  if (!stamp_) return std::nullopt;
  State state{pose_, stale_ ? Vector2(Vector2::Zero()) : velocity_, jumped_, stale_};
  const Vector2 moved_on = pose_.position + std::clamp(age, 0.0, tick_duration_) * velocity_;
  if (!stale_ && isPlace(moved_on)) state.pose.position = moved_on;
  jumped_ = false;
  return state;
}

}  // namespace crowd
