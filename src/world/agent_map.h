#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "world/perception.h"

namespace crowd {

/// @brief Where nobody reports that agents have left, so many are remembered before those that have are looked for.
constexpr std::size_t FEW_AGENTS = 1000;

/// @brief A value for each of some agents, in one array by ascending id. Agents may leave at any time, so that a loop
/// over it costs what the present agents cost; ids are not used again. Until one leaves, agent i is at position i.
template <typename Value>
class AgentMap {
 public:
  AgentMap() = default;
  /// @brief Values of the agents 0, 1, 2 ...
  AgentMap(std::vector<Value> values) {  // NOLINT(google-explicit-constructor): a list is one
    replace(std::move(values));
  }

  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  /// @brief The values, by ascending id.
  const std::vector<Value>& values() const { return values_; }
  typename std::vector<Value>::const_iterator begin() const { return values_.begin(); }
  typename std::vector<Value>::const_iterator end() const { return values_.end(); }
  typename std::vector<Value>::iterator begin() { return values_.begin(); }
  typename std::vector<Value>::iterator end() { return values_.end(); }
  const Value& front() const { return values_.front(); }
  const Value& back() const { return values_.back(); }

  /// @brief Where an agent is in values(); size() if it is not there.
  std::size_t positionOf(AgentId id) const {
    if (id < unmoved_) return id;
    const std::size_t position = lowerBound(id);
    return position < ids_.size() && ids_[position] == id ? position : ids_.size();
  }
  /// @brief Position of the first agent that has this id or a higher one.
  std::size_t lowerBound(AgentId id) const {
    if (id <= unmoved_) return id;
    const auto moved = ids_.begin() + static_cast<std::ptrdiff_t>(unmoved_);
    return static_cast<std::size_t>(std::lower_bound(moved, ids_.end(), id) - ids_.begin());
  }
  AgentId idAt(std::size_t position) const { return ids_[position]; }
  const Value& nth(std::size_t position) const { return values_[position]; }
  Value& nth(std::size_t position) { return values_[position]; }

  bool contains(AgentId id) const { return positionOf(id) < size(); }
  /// @brief The value of an agent; null if it is not there.
  const Value* find(AgentId id) const {
    const std::size_t position = positionOf(id);
    return position < size() ? &values_[position] : nullptr;
  }
  Value* find(AgentId id) {
    const std::size_t position = positionOf(id);
    return position < size() ? &values_[position] : nullptr;
  }
  /// @brief The value of an agent that must be there.
  const Value& operator[](AgentId id) const { return values_[positionOf(id)]; }
  Value& operator[](AgentId id) { return values_[positionOf(id)]; }

  /// @brief The value of an agent, which is added if it is not there.
  Value& add(AgentId id) {
    const std::size_t position = ids_.empty() || ids_.back() < id ? size() : lowerBound(id);
    if (position < size() && ids_[position] == id) return values_[position];
    ids_.insert(ids_.begin() + static_cast<std::ptrdiff_t>(position), id);
    Value& value = *values_.emplace(values_.begin() + static_cast<std::ptrdiff_t>(position));
    countUnmoved();
    return value;
  }
  /// @brief Replaces everything by values of the agents 0, 1, 2 ... @return the former values
  std::vector<Value> replace(std::vector<Value> values) {
    values_.swap(values);
    ids_.resize(values_.size());
    for (std::size_t i = 0; i < ids_.size(); ++i) ids_[i] = static_cast<AgentId>(i);
    unmoved_ = ids_.size();
    return values;
  }
  void clear() { replace({}); }

  /// @brief Removes the agents for which leaves(id, value) returns true, which is called once for each.
  template <typename Leaves>
  void eraseIf(const Leaves& leaves) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      if (leaves(ids_[i], values_[i])) continue;
      if (kept < i) {
        ids_[kept] = ids_[i];
        values_[kept] = std::move(values_[i]);
      }
      ++kept;
    }
    ids_.resize(kept);
    values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(kept), values_.end());
    unmoved_ = 0;
    countUnmoved();
  }
  /// @brief Removes the agents that are not among others, after forget(id, value) was called for each of them.
  template <typename Other, typename Forget>
  void keepOnly(const AgentMap<Other>& others, const Forget& forget) {
    if (ids_ == others.ids_) return;
    auto other = others.ids_.begin();
    eraseIf([&](AgentId id, Value& value) {
      while (other != others.ids_.end() && *other < id) ++other;
      if (other != others.ids_.end() && *other == id) return false;
      forget(id, value);
      return true;
    });
  }
  /// @brief Makes the agents the same as these; new ones have a default value.
  template <typename Other>
  void follow(const AgentMap<Other>& others) {
    keepOnly(others, [](AgentId, const Value&) {});
    for (std::size_t i = 0; size() < others.size(); ++i) {
      if (i == size() || ids_[i] != others.ids_[i]) add(others.ids_[i]);
    }
  }

 private:
  template <typename Other>
  friend class AgentMap;

  void countUnmoved() {
    while (unmoved_ < ids_.size() && ids_[unmoved_] == unmoved_) ++unmoved_;
  }

  std::vector<AgentId> ids_;
  std::vector<Value> values_;
  std::size_t unmoved_ = 0;  // the first ones, whose positions are their ids
};

}  // namespace crowd
