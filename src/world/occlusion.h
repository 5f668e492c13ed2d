#pragma once

#include <cstddef>
#include <vector>

#include "world/perception.h"

namespace crowd {

/// @brief Removes from a perception what nearer bodies and walls hide from the agent's centre.
///
/// A completely hidden body is removed. A partly hidden body is replaced by the disc that its visible part spans, from
/// the first to the last visible point: the fractions a to b of its chord, counted from the right, give a disc of
/// radius (b - a) R, shifted by (a + b - 1) R to the left along the chord. The disc lies within the body, equals the
/// body if neither flank is hidden, and shrinks to zero with the visible part. If a small separate visible part at one
/// flank disappears, the disc jumps to the remaining part. A partly hidden body still hides others with its whole size.
/// Walls are cut to their visible parts.
///
/// Each disc is represented by the chord between the tangent points of the lines of sight, each wall by itself. For
/// objects that do not overlap, these chords have the same depth order as the objects. All tests use cross products, so
/// that no angle wraps. A body that contains the agent's centre and a wall seen edge-on hide nothing, and are
/// perceived.
///
/// Use one object per thread; it keeps its workspace.
class Occlusion {
 public:
  /// @brief Applies occlusion to the neighbours from `first_neighbour` on and the walls from `first_wall` on.
  /// @param neighbours of one agent, in its frame, sorted by the distance of their rims on input and output; the sort
  /// is stable
  /// @param walls of the same agent, in its frame
  /// @param radius vision radius [m]; visible parts beyond it are removed, too
  void apply(std::vector<Neighbour>& neighbours, std::size_t first_neighbour, std::vector<Segment>& walls,
             std::size_t first_wall, double radius);

 private:
  /// A chord; `right` and `left` are its ends as seen from the origin.
  struct Screen {
    Vector2 right = Vector2::Zero();
    Vector2 left = Vector2::Zero();
    bool hides = false;

    bool covers(const Vector2& direction) const {
      return cross(right, direction) >= 0.0 && cross(direction, left) >= 0.0;
    }
    /// Fraction of the chord, from the right, where a line of sight meets it; requires covers(direction).
    double shareAt(const Vector2& direction) const {
      const double from_right = cross(right, direction);
      return from_right / (from_right + cross(direction, left));
    }
    Vector2 at(double share) const {
      if (share <= 0.0) return right;
      return share >= 1.0 ? left : Vector2(right + share * (left - right));
    }
    /// Distance by which the line of the chord is in front of a point, relative to its distance from the origin.
    double inFrontOf(const Vector2& point) const { return cross(point - right, left - right) / cross(right, left); }
  };
  /// Part of a chord, as fractions of its length from its right end.
  struct Part {
    double from = 0.0;
    double to = 1.0;

    bool isAll() const { return from <= 0.0 && to >= 1.0; }
  };

  static Screen screenOf(const Neighbour& neighbour);
  static Screen screenOf(const Segment& wall);
  /// The disc that a part of the chord of a body spans.
  static Neighbour spanned(const Neighbour& neighbour, const Screen& chord, const Part& part);
  void addHiddenPart(const Screen& seen, const Screen& other);
  /// Returns the visible parts of a chord; `own` is its index in `screens_`, or any index beyond the end.
  const std::vector<Part>& visibleParts(const Screen& seen, std::size_t own);
  /// Adds the screens of the bodies, nearest first, and removes bodies that are completely hidden by those before them.
  /// Removed bodies need no screen: what they hide is also hidden by the bodies in front of them.
  void screenNeighbours(std::vector<Neighbour>& neighbours, std::size_t first);
  /// Reduces bodies to their visible parts. All screens count: a small body may occlude a larger one whose rim is
  /// nearer.
  void cutNeighbours(std::vector<Neighbour>& neighbours, std::size_t first, std::size_t first_screen, double radius);
  void cutWalls(std::vector<Segment>& walls, std::size_t first, double radius);

  std::vector<Screen> screens_;  // of the walls, then of the bodies
  std::vector<Part> hidden_;
  std::vector<Part> visible_;
  std::vector<Segment> cut_;
};

}  // namespace crowd
