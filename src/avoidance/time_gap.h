#pragma once

#include <cstddef>

#include "avoidance/candidate_move.h"
#include "world/perception.h"

namespace crowd {

/// @brief Limits the speed towards other agents ahead, as people keep a distance that grows with their speed: the gap
/// between the bodies takes at least a certain time to walk (collision-free speed model of Tordeux, Chraibi and
/// Seyfried 2016, v = gap / time gap).
///
/// With an anticipation time a move is admissible, too, if the gap takes the time gap to walk after this time, in which
/// the other one keeps its velocity and the agent walks as the move says (ours). So agents start soon after those ahead
/// of them. Who follows another one at the same speed has the same gap as without.
///
/// The time gap is that of a person with the maximum speed REFERENCE_SPEED; others walk at the same fraction of their
/// maximum speed at the same gap. Measured speeds in corridors are in this ratio at all densities (docs/human.md).
/// Walls and obstacles limit nothing. Immutable: any number of threads may call cut() with buffers of their own.
class TimeGap {
 public:
  /// @brief Maximum speed of a person whose time gap is `time_gap`: mean free speed of pedestrians (Weidmann 1993)
  /// [m/s].
  static constexpr double REFERENCE_SPEED = 1.34;

  /// @param time_gap [s], not negative; 0: no move is limited
  /// @param width an agent is ahead of a move if its centre is less than this share of the sum of both radii aside of
  /// the move's line, not negative
  /// @param anticipation_time for which gaps are extrapolated [s], not negative; 0: gaps are those of the moment
  TimeGap(double time_gap, double width, double anticipation_time)
      : walked_(time_gap * REFERENCE_SPEED), width_(width), anticipation_time_(anticipation_time) {}

  /// @brief Whether any move can be limited.
  bool isOn() const { return walked_ > 0.0; }
  /// @brief Decreases the admissible fraction of each of the first `count` moves to that of the agents ahead of the
  /// move that admits the least. It is gap / (time gap x REFERENCE_SPEED), and more if the gap opens.
  /// @param moves blocksOf(count) blocks
  void cut(const Perception& perception, MoveBlock* moves, std::size_t count) const;

 private:
  double walked_;  // at the reference speed in the time gap [m]
  double width_;
  double anticipation_time_;  // [s]
};

}  // namespace crowd
