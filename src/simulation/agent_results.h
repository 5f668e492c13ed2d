#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <vector>

#include "common/files/scratch_file.h"
#include "social_crowd/results.h"
#include "world/agent_map.h"

namespace crowd {

/// @brief Results of the agents 0, 1, 2 ... of an episode. Those of many agents that have left are in a temporary file,
/// so that a long episode takes no more memory than a short one; they are read when they are asked for.
///
/// Copies share the file: only the one that calls storeIfMany() may add further agents.
class AgentResults {
 public:
  AgentResults() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a list is one
  AgentResults(std::vector<AgentResult> results) : held_(std::move(results)), size_(held_.size()) {}
  AgentResults(std::initializer_list<AgentResult> results) : AgentResults(std::vector<AgentResult>(results)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// @throws FileError if the temporary file cannot be read
  AgentResult operator[](std::size_t agent) const;
  /// @throws std::out_of_range also if there is no such agent
  AgentResult at(std::size_t agent) const;

  /// @brief Iterates over copies.
  class Iterator {
   public:
    // NOLINTBEGIN(readability-identifier-naming): names of the standard library
    using iterator_category = std::input_iterator_tag;
    using value_type = AgentResult;
    using difference_type = std::ptrdiff_t;
    using pointer = const AgentResult*;
    using reference = AgentResult;
    // NOLINTEND(readability-identifier-naming)

    Iterator(const AgentResults& results, std::size_t agent) : results_(&results), agent_(agent) {}
    AgentResult operator*() const { return (*results_)[agent_]; }
    Iterator& operator++() {
      ++agent_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return agent_ != other.agent_; }

   private:
    const AgentResults* results_;
    std::size_t agent_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

  /// @brief The result of an agent that has not left, which is added if it is not there.
  AgentResult& add(AgentId agent);
  /// @brief Moves all results to the file if there are many. @throws FileError
  void storeIfMany();

 private:
  static constexpr std::size_t MANY = 1024;

  AgentMap<AgentResult> held_;
  std::shared_ptr<ScratchFile> file_;  // of all others, by agent
  std::size_t size_ = 0;
};

}  // namespace crowd
