#include "ros/messages/motion_fields.h"

#include <social_crowd/Perceptions.h>

namespace crowd {
namespace {

double toField(double limit) { return limit < INFINITE ? limit : 0.0; }
double fromField(double field) { return field == 0.0 ? INFINITE : field; }

}  // namespace

MotionFields toFields(const MotionLimits& motion) {
  return {toField(motion.acceleration), toField(motion.braking), toField(motion.turn_rate)};
}

MotionLimits fromFields(const MotionFields& fields) {
  return {fromField(fields.acceleration), fromField(fields.braking), fromField(fields.turn_rate)};
}

std::optional<MotionLimits> requestOf(std::uint8_t source, const MotionLimits& motion) {
  if (source == social_crowd::Perceptions::MOTION_UNKNOWN) return std::nullopt;
  return source == social_crowd::Perceptions::MOTION_OF_SCENARIO ? MotionLimits() : motion;
}

}  // namespace crowd
