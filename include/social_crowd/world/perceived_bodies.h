#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief What kind of body is perceived.
enum class BodyKind : std::uint8_t { AGENT = 0, OBSTACLE = 1 };

/// @brief Another body, or what is seen of it, in the frame of the agent that perceives it (x ahead, y left).
struct PerceivedBody {
  Vector2 position = Vector2::Zero();  ///< of the centre [m]
  Vector2 velocity = Vector2::Zero();  ///< over ground, of the last tick [m/s]
  double radius = 0.0;                 ///< [m]
  BodyKind kind = BodyKind::AGENT;
};

/// @brief How far its rim is away; negative from a point within it [m].
inline double rimDistance(const PerceivedBody& body) { return body.position.norm() - body.radius; }

/// @brief A list of bodies that is kept as a list of each of their numbers, so that loops over many bodies can be done
/// with vector instructions.
class PerceivedBodies {
 public:
  /// @brief So many numbers behind the last may be read, whatever they are: loops need not end with the bodies.
  static constexpr std::size_t MARGIN = 16;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  /// @brief Changes the length; what is new is to be set.
  void resize(std::size_t size) {
    size_ = size;
    if (kinds_.size() < size + MARGIN) grow(size);
  }
  /// @brief Adds a body behind the last.
  void push_back(const PerceivedBody& body) {  // NOLINT(readability-identifier-naming): as all lists have it
    resize(size_ + 1);
    set(size_ - 1, body);
  }
  /// @brief Body number `i`, as a copy; set() writes it.
  PerceivedBody operator[](std::size_t i) const { return {{xs_[i], ys_[i]}, {vxs_[i], vys_[i]}, radii_[i], kinds_[i]}; }
  void set(std::size_t i, const PerceivedBody& body) {
    xs_[i] = body.position.x();
    ys_[i] = body.position.y();
    vxs_[i] = body.velocity.x();
    vys_[i] = body.velocity.y();
    radii_[i] = body.radius;
    kinds_[i] = body.kind;
  }

  /// @brief Their numbers one by one, see PerceivedBody; margins included.
  const double* xs() const { return xs_.data(); }
  const double* ys() const { return ys_.data(); }
  const double* vxs() const { return vxs_.data(); }
  const double* vys() const { return vys_.data(); }
  const double* radii() const { return radii_.data(); }
  const BodyKind* kinds() const { return kinds_.data(); }
  /// @brief The same, for those who write several at once: size() of them.
  double* xs() { return xs_.data(); }
  double* ys() { return ys_.data(); }
  double* vxs() { return vxs_.data(); }
  double* vys() { return vys_.data(); }
  double* radii() { return radii_.data(); }
  BodyKind* kinds() { return kinds_.data(); }

 private:
  void grow(std::size_t size);

  std::size_t size_ = 0;
  std::vector<double> xs_;
  std::vector<double> ys_;
  std::vector<double> vxs_;
  std::vector<double> vys_;
  std::vector<double> radii_;
  std::vector<BodyKind> kinds_;
};

/// @brief Some of the bodies of a list, one after the other; valid as long as that list is unchanged.
class PerceivedBodiesView {
 public:
  PerceivedBodiesView(const PerceivedBodies& bodies, std::size_t first, std::size_t count)
      : bodies_(&bodies), first_(first), count_(count) {}
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  PerceivedBody operator[](std::size_t i) const { return (*bodies_)[first_ + i]; }
  /// @brief Whether not all of them are agents.
  bool hasObstacles() const {
    std::size_t i = 0;
    for (; i + EIGHT <= count_; i += EIGHT) {
      if (kindsFrom(i) != 0) return true;
    }
    // What stands behind the last one is shifted out.
    return i < count_ && kindsFrom(i) << (8 * (EIGHT - (count_ - i))) != 0;
  }
  /// @brief The first so many of them.
  PerceivedBodiesView front(std::size_t count) const { return {*bodies_, first_, count}; }

  /// @brief Their numbers one by one, as PerceivedBodies has them.
  const double* xs() const { return bodies_->xs() + first_; }
  const double* ys() const { return bodies_->ys() + first_; }
  const double* vxs() const { return bodies_->vxs() + first_; }
  const double* vys() const { return bodies_->vys() + first_; }
  const double* radii() const { return bodies_->radii() + first_; }
  const BodyKind* kinds() const { return bodies_->kinds() + first_; }

  /// @brief Goes from body to body.
  class Iterator {
   public:
    // NOLINTBEGIN(readability-identifier-naming): the names that the standard library asks for
    using iterator_category = std::input_iterator_tag;
    using value_type = PerceivedBody;
    using difference_type = std::ptrdiff_t;
    using pointer = const PerceivedBody*;
    using reference = PerceivedBody;
    // NOLINTEND(readability-identifier-naming)

    Iterator(const PerceivedBodies& bodies, std::size_t i) : bodies_(&bodies), i_(i) {}
    PerceivedBody operator*() const { return (*bodies_)[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return i_ == other.i_; }
    bool operator!=(const Iterator& other) const { return i_ != other.i_; }

   private:
    const PerceivedBodies* bodies_;
    std::size_t i_;
  };
  Iterator begin() const { return {*bodies_, first_}; }
  Iterator end() const { return {*bodies_, first_ + count_}; }

 private:
  static constexpr std::size_t EIGHT = sizeof(std::uint64_t);
  static_assert(static_cast<int>(BodyKind::AGENT) == 0 && sizeof(BodyKind) == 1, "eight agents are a 0");
#if defined(__BYTE_ORDER__)
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the first kind is in the lowest byte");
#endif
  /// Eight kinds at once, the first one in the lowest byte; 0 if all are agents.
  std::uint64_t kindsFrom(std::size_t i) const {
    std::uint64_t eight = 0;
    std::memcpy(&eight, kinds() + i, EIGHT);
    return eight;
  }

  const PerceivedBodies* bodies_;
  std::size_t first_;
  std::size_t count_;
};

}  // namespace crowd
