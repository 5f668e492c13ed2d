#pragma once

#include <cstddef>
#include <vector>

#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Leaves out of a perception what nearer bodies and walls hide from the agent's centre.
///
/// A body of which nothing is seen is left out. Of one that is partly hidden that disc is perceived which the part from
/// the first to the last that is seen of it spans: shares a to b of its chord, from the right, make a disc of radius
/// (b - a) R, shifted by (a + b - 1) R to the left along the chord. It lies within the body, is the body itself where
/// neither flank is hidden, and shrinks to nothing with the last of it that is seen; when a glimpse beside another part
/// is lost, it jumps to that other part. Bodies hide as they are, however little is seen of them. Walls are cut to the
/// parts that are seen.
///
/// A disc is looked at as its chord between the two points where the lines of sight touch it, a wall as what it is:
/// things that do not overlap stand before each other as these chords do. So all is done with cross products, and
/// angles never wrap. A body in which the agent's centre lies hides nothing, nor does a wall seen edge-on; both are
/// perceived.
class Occlusion {
 public:
  /// @param neighbours from number `first_neighbour` on, and walls from `first_wall` on, are those of one agent, in its
  /// frame; what lies before stays as it is. Neighbours come and leave nearest rim first; equal ones stay in their
  /// order.
  /// @param radius of vision; parts of bodies and walls that lie beyond are left out, too [m]
  void apply(std::vector<Neighbour>& neighbours, std::size_t first_neighbour, std::vector<Segment>& walls,
             std::size_t first_wall, double radius);

 private:
  /// A chord, with its ends as they are seen from the origin.
  struct Screen {
    Vector2 right = Vector2::Zero();
    Vector2 left = Vector2::Zero();
    bool hides = false;

    bool covers(const Vector2& direction) const {
      return cross(right, direction) >= 0.0 && cross(direction, left) >= 0.0;
    }
    /// Where a line of sight meets the chord; for directions that it covers.
    double shareAt(const Vector2& direction) const {
      const double from_right = cross(right, direction);
      return from_right / (from_right + cross(direction, left));
    }
    Vector2 at(double share) const {
      if (share <= 0.0) return right;
      return share >= 1.0 ? left : Vector2(right + share * (left - right));
    }
    /// How far the chord's line lies in front of a point, in distances of that line from the origin.
    double inFrontOf(const Vector2& point) const { return cross(point - right, left - right) / cross(right, left); }
  };
  /// Part of a chord: shares of it, from its right end.
  struct Part {
    double from = 0.0;
    double to = 1.0;

    bool isAll() const { return from <= 0.0 && to >= 1.0; }
  };

  static Screen screenOf(const Neighbour& neighbour);
  static Screen screenOf(const Segment& wall);
  /// The disc that a part of a body's chord spans.
  static Neighbour spanned(const Neighbour& neighbour, const Screen& chord, const Part& part);
  void addHiddenPart(const Screen& seen, const Screen& other);
  /// Finds the parts of a thing that the screens leave to be seen; its own number among them, or a number beyond them.
  const std::vector<Part>& visibleParts(const Screen& seen, std::size_t own);
  /// Adds the screens of the bodies. Near ones come first and hide most of the others, which then need not be looked
  /// at as screens and are left out: what they hide is hidden by those in front of them as well.
  void screenNeighbours(std::vector<Neighbour>& neighbours, std::size_t first);
  /// Leaves what is seen of them: also one with its rim a bit further away may stand before one that is larger.
  void cutNeighbours(std::vector<Neighbour>& neighbours, std::size_t first, std::size_t first_screen, double radius);
  void cutWalls(std::vector<Segment>& walls, std::size_t first, double radius);

  std::vector<Screen> screens_;  // of the walls, then of the bodies
  std::vector<Part> hidden_;
  std::vector<Part> visible_;
  std::vector<Segment> cut_;
};

}  // namespace crowd
