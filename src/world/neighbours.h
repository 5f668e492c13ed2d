#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Kind of a perceived body. UNYIELDED_ROBOT: a robot that agents see, but do not yield to.
enum class NeighbourKind : std::uint8_t { AGENT = 0, OBSTACLE = 1, ROBOT = 2, UNYIELDED_ROBOT = 3 };

/// @brief What people read from a robot besides its motion, in the frame of the agent that perceives it.
struct RobotIntent {
  double comfort = 0.0;              ///< distance that people keep from it where there is room [m]
  Vector2 wanted = Vector2::Zero();  ///< velocity at which it will go on: its own, or that of one that waits [m/s]
};

/// @brief Whether a body is a robot.
constexpr bool isRobot(NeighbourKind kind) {
  return kind == NeighbourKind::ROBOT || kind == NeighbourKind::UNYIELDED_ROBOT;
}

/// @brief Another body, or its visible part, in the frame of the agent that perceives it (x ahead, y left).
struct Neighbour {
  Vector2 position = Vector2::Zero();  ///< centre [m]
  Vector2 velocity = Vector2::Zero();  ///< over ground, in the last tick [m/s]
  double radius = 0.0;                 ///< [m]
  NeighbourKind kind = NeighbourKind::AGENT;
  RobotIntent intent = {};  ///< of a robot
};

/// @brief Distance from the agent's centre to the rim [m]; negative if the centre is inside.
inline double rimDistance(const Neighbour& neighbour) { return neighbour.position.norm() - neighbour.radius; }

/// @brief List of neighbours as a structure of arrays, so that loops over many neighbours can use vector instructions.
class NeighbourList {
 public:
  /// @brief Number of elements that may be read beyond the last one of each array; their values are unspecified.
  static constexpr std::size_t PADDING = 16;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  /// @brief Changes the length; new elements are unspecified until set().
  void resize(std::size_t size) {
    size_ = size;
    if (kinds_.size() < size + PADDING) grow(size);
  }
  /// @brief Appends a neighbour.
  void push_back(const Neighbour& neighbour) {  // NOLINT(readability-identifier-naming): as in the standard library
    resize(size_ + 1);
    set(size_ - 1, neighbour);
  }
  /// @brief Neighbour `i`, as a copy; set() writes it.
  Neighbour operator[](std::size_t i) const {
    const RobotIntent intent = isRobot(kinds_[i]) ? intents_[i] : RobotIntent();
    return {{xs_[i], ys_[i]}, {vxs_[i], vys_[i]}, radii_[i], kinds_[i], intent};
  }
  void set(std::size_t i, const Neighbour& neighbour) {
    xs_[i] = neighbour.position.x();
    ys_[i] = neighbour.position.y();
    vxs_[i] = neighbour.velocity.x();
    vys_[i] = neighbour.velocity.y();
    radii_[i] = neighbour.radius;
    kinds_[i] = neighbour.kind;
    if (isRobot(neighbour.kind)) setIntent(i, neighbour.intent);
  }

  /// @brief Arrays of the fields of Neighbour, PADDING elements may be read beyond the last.
  const double* xs() const { return xs_.data(); }
  const double* ys() const { return ys_.data(); }
  const double* vxs() const { return vxs_.data(); }
  const double* vys() const { return vys_.data(); }
  const double* radii() const { return radii_.data(); }
  const NeighbourKind* kinds() const { return kinds_.data(); }
  /// @brief The same arrays for writing; size() elements each.
  double* xs() { return xs_.data(); }
  double* ys() { return ys_.data(); }
  double* vxs() { return vxs_.data(); }
  double* vys() { return vys_.data(); }
  double* radii() { return radii_.data(); }
  NeighbourKind* kinds() { return kinds_.data(); }

 private:
  void grow(std::size_t size);
  void setIntent(std::size_t i, const RobotIntent& intent);

  std::size_t size_ = 0;
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<double> vxs_;
  std::vector<double> vys_;
  std::vector<double> radii_;
  std::vector<NeighbourKind> kinds_;
  std::vector<RobotIntent> intents_;  // up to the last robot; those of others are not used
};

/// @brief View of consecutive neighbours of a list; valid as long as the list is unchanged.
class NeighbourSpan {
 public:
  NeighbourSpan(const NeighbourList& neighbours, std::size_t first, std::size_t count)
      : neighbours_(&neighbours), first_(first), count_(count) {}
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  Neighbour operator[](std::size_t i) const { return (*neighbours_)[first_ + i]; }
  /// @brief Whether any of them is an obstacle.
  bool hasObstacles() const {
    std::size_t i = 0;
    for (; i + EIGHT <= count_; i += EIGHT) {
      if (kindsFrom(i) != 0) return true;
    }
    // The shift discards the bytes behind the last neighbour.
    return i < count_ && kindsFrom(i) << (8 * (EIGHT - (count_ - i))) != 0;
  }
  /// @brief View of the first `count` of them.
  NeighbourSpan front(std::size_t count) const { return {*neighbours_, first_, count}; }

  /// @brief Arrays of the fields, as in NeighbourList.
  const double* xs() const { return neighbours_->xs() + first_; }
  const double* ys() const { return neighbours_->ys() + first_; }
  const double* vxs() const { return neighbours_->vxs() + first_; }
  const double* vys() const { return neighbours_->vys() + first_; }
  const double* radii() const { return neighbours_->radii() + first_; }
  const NeighbourKind* kinds() const { return neighbours_->kinds() + first_; }

  /// @brief Input iterator that returns copies.
  class Iterator {
   public:
    // NOLINTBEGIN(readability-identifier-naming): names required by the standard library
    using iterator_category = std::input_iterator_tag;
    using value_type = Neighbour;
    using difference_type = std::ptrdiff_t;
    using pointer = const Neighbour*;
    using reference = Neighbour;
    // NOLINTEND(readability-identifier-naming)

    Iterator(const NeighbourList& neighbours, std::size_t i) : neighbours_(&neighbours), i_(i) {}
    Neighbour operator*() const { return (*neighbours_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return i_ == other.i_; }
    bool operator!=(const Iterator& other) const { return i_ != other.i_; }

   private:
    const NeighbourList* neighbours_;
    std::size_t i_;
  };
  Iterator begin() const { return {*neighbours_, first_}; }
  Iterator end() const { return {*neighbours_, first_ + count_}; }

 private:
  static constexpr std::size_t EIGHT = sizeof(std::uint64_t);
  static_assert(static_cast<int>(NeighbourKind::AGENT) == 0 && sizeof(NeighbourKind) == 1, "eight agents are a 0");
#if defined(__BYTE_ORDER__)
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the first kind is in the lowest byte");
#endif
  /// Eight kinds in one word, the first in the lowest byte; 0 if all are agents.
  std::uint64_t kindsFrom(std::size_t i) const {
    std::uint64_t eight = 0;
    std::memcpy(&eight, kinds() + i, EIGHT);
    return eight;
  }

  const NeighbourList* neighbours_;
  std::size_t first_;
  std::size_t count_;
};

}  // namespace crowd
