#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "social_crowd/perception.h"

namespace crowd {
struct TrainedTable;
}

namespace crowd::library {

/// @brief A learned Q-table with its state set, action set and reward. Immutable; copies share the values, and any
/// threads may use them at the same time.
class QTable {
 public:
  /// @brief Reads a Q-table file, or a Q-table of the package by its name, such as "anticipation".
  /// @throws FileError if it cannot be read; InputError if there is no such name or the file is damaged
  static QTable load(const std::string& name_or_file);
  /// @brief Writes a file that load() reads, bit for bit; an existing file is replaced when the new one is complete.
  /// @throws FileError
  void save(const std::string& file) const;

  /// @brief What its agents need to perceive.
  Vision vision() const;
  /// @brief State set, action set and reward in YAML, a line each, as in the file.
  std::string model() const;
  /// @brief Number of decisions that it was learned from.
  std::uint64_t decisions() const;
  std::size_t rows() const;
  std::size_t actions() const;
  /// @brief The value of an action in a row. @throws InputError if there is no such row or action
  double value(std::size_t row, std::size_t action) const;

  /// @brief For this library only.
  explicit QTable(std::shared_ptr<const TrainedTable> trained) : trained_(std::move(trained)) {}
  const TrainedTable& trained() const { return *trained_; }

 private:
  std::shared_ptr<const TrainedTable> trained_;
};

}  // namespace crowd::library
