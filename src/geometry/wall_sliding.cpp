#include "geometry/wall_sliding.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

constexpr int ROUNDS = 40;             // of impulses; those of two walls in a corner depend on each other
constexpr double AT_REST = 1e-9;       // of the speed: rounding [m/s]
constexpr double INERTIA_SHARE = 0.4;  // square of the radius of gyration / that of the reach, as of a rectangle 2 : 1

Vector2 left(const Vector2& vector) { return {-vector.y(), vector.x()}; }

/// Speed at which the point of a contact moves into the wall [m/s].
double closing(const WallContact& contact, const BodyMotion& motion) {
  return contact.normal.dot(motion.velocity + motion.rotation * left(contact.arm));
}

/// Changes a motion by the impulses of the walls, none of which pulls (projected Gauss-Seidel method).
/// @param inertia per mass [m^2]; infinite: it keeps its rotation
void takeImpulses(const std::vector<WallContact>& contacts, double inertia, BodyMotion& motion) {
  std::vector<double> impulses(contacts.size(), 0.0);
  for (int round = 0; round < ROUNDS; ++round) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const double lever = std::isinf(inertia) ? 0.0 : contacts[i].normal.dot(left(contacts[i].arm));
      const double turned = lever / inertia;  // per impulse
      const double more = std::max(-impulses[i], closing(contacts[i], motion) / (1.0 + lever * turned));
      impulses[i] += more;
      motion.velocity -= more * contacts[i].normal;
      motion.rotation -= more * turned;
    }
  }
}

/// Takes away what still leads into the walls. @param margin speed out of them [m/s]
void clear(const std::vector<WallContact>& contacts, double margin, BodyMotion& motion) {
  for (int round = 0; round < ROUNDS; ++round) {
    for (const WallContact& contact : contacts) {
      motion.velocity -= std::max(0.0, closing(contact, motion) + margin) * contact.normal;
    }
  }
  const auto leads_in = [&](const WallContact& contact) { return closing(contact, motion) > AT_REST; };
  if (std::any_of(contacts.begin(), contacts.end(), leads_in)) motion.velocity.setZero();
  if (std::any_of(contacts.begin(), contacts.end(), leads_in)) motion.rotation = 0.0;
  if (motion.velocity.norm() < AT_REST) motion.velocity.setZero();
}

/// The speed at which a footprint with corners leaves a wall [m/s]: its points move on arcs while it turns, and
/// rounding must not move a side into the wall on which it slides.
double marginOf(double rotation, double reach, double time) {
  constexpr double LEAST = 1e-6;
  return std::max(LEAST, 0.5 * rotation * rotation * reach * time);
}

void addCornerContacts(const std::vector<Vector2>& corners, const Vector2& position, const Segment& wall,
                       double tolerance, std::vector<WallContact>& contacts) {
  const Vector2 along = wall.to - wall.from;
  Vector2 middle = Vector2::Zero();
  for (const Vector2& corner : corners) middle += corner / static_cast<double>(corners.size());
  const double side = cross(along, middle - wall.from);
  const Vector2 normal = (side > 0.0 ? -1.0 : 1.0) * left(along).normalized();
  for (const Vector2& corner : corners) {
    const double share = (corner - wall.from).dot(along) / along.squaredNorm();
    if (share < 0.0 || share > 1.0 || distanceTo(wall, corner) > tolerance) continue;
    contacts.push_back({corner - position, normal});
  }
}

/// Ends of a wall that touch a side.
void addEndContacts(const std::vector<Vector2>& corners, const Vector2& position, const Segment& wall, double tolerance,
                    std::vector<WallContact>& contacts) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) area += cross(corners[i], corners[(i + 1) % corners.size()]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment side{corners[i], corners[(i + 1) % corners.size()]};
    const Vector2 outwards = (area > 0.0 ? -1.0 : 1.0) * left(side.to - side.from).normalized();
    for (const Vector2& end : {wall.from, wall.to}) {
      if (distanceTo(side, end) <= tolerance) contacts.push_back({end - position, outwards});
    }
  }
}

}  // namespace

void addContacts(const Footprint& footprint, const Pose& pose, const Segment& wall, double tolerance,
                 std::vector<WallContact>& contacts) {
  if (distance(footprint, pose, wall) > tolerance) return;
  if (footprint.isDisc()) {
    const Vector2 arm = nearestPoint(wall, pose.position) - pose.position;
    if (arm.norm() > 0.0) contacts.push_back({arm, arm.normalized()});
    return;
  }
  const std::vector<Vector2> corners = footprint.cornersAt(pose);
  addCornerContacts(corners, pose.position, wall, tolerance, contacts);
  addEndContacts(corners, pose.position, wall, tolerance, contacts);
}

BodyMotion slideAlongWalls(const Footprint& footprint, const std::vector<WallContact>& contacts,
                           const BodyMotion& motion, const WallSliding& sliding, double time) {
  const double reach = footprint.reach();
  const double inertia = footprint.isDisc() ? INFINITE : INERTIA_SHARE * reach * reach;
  BodyMotion slid = motion;
  takeImpulses(contacts, inertia, slid);
  const double most = std::max(std::abs(motion.rotation), sliding.max_rotation);
  slid.rotation = std::clamp(slid.rotation, -most, most);
  const double speed = motion.velocity.norm();
  if (!sliding.turns_on_the_spot && speed > 0.0) slid.rotation *= std::min(1.0, slid.velocity.norm() / speed);
  clear(contacts, footprint.isDisc() ? 0.0 : marginOf(slid.rotation, reach, time), slid);
  return slid;
}

}  // namespace crowd
