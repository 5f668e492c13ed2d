#pragma once

#include <cstddef>
#include <optional>

#include "scenario/population_spec.h"
#include "world/world.h"

namespace crowd {

/// @brief A gate: its wall is in the world while it is closed. It closes only when no agent stands in it.
///
/// A gate with periods follows them. setOpen() holds until the next period begins or ends.
class Gate {
 public:
  /// @param gate must outlive it
  explicit Gate(const GateDescription& gate) : gate_(&gate) {}

  /// @brief Adds or removes the wall according to the present time and setOpen(). Call it at the start and after each
  /// tick; also after changes of the walls by others, which may have removed this one.
  void update(World& world);
  /// @brief Opens or closes the gate at the next update(). @param time [s]
  void setOpen(bool open, double time);
  /// @brief Whether the wall was absent after the last update().
  bool isOpen() const { return !wall_; }

 private:
  void follow(double time);

  const GateDescription* gate_;
  std::optional<bool> scheduled_;  // by the description, at the last update
  bool wants_open_ = false;
  std::optional<std::size_t> wall_;  // id of the wall while it is closed
};

}  // namespace crowd
