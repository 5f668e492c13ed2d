#pragma once

#include <cstdint>
#include <vector>

#include "training/communicator.h"
#include "world/world.h"

namespace crowd {

/// @brief The agents near the borders of a rank: own ones of which other ranks have copies, and copies of agents of
/// others. Sends what they do in a tick; between two calls of set() messages have the same agents in the same order.
class BorderExchange {
 public:
  /// @brief Agents that this rank and another one have in common.
  struct Shared {
    std::vector<AgentId> sent;          ///< own agents
    std::vector<AgentId> received;      ///< copies
    std::vector<std::uint8_t> is_near;  ///< by copy: own agents may touch it
  };

  explicit BorderExchange(Communicator& communicator) : communicator_(communicator) {}

  /// @param shared by rank @param world that the agents are in
  void set(std::vector<Shared> shared, const World& world);

  /// @brief Appends the actions of the copies to those of the own agents. Collective.
  void exchangeActions(const World& world, std::vector<AgentAction>& actions);
  /// @brief Between beginStep() and endStep() of a solid world: replaces the outcomes of the copies by those that their
  /// own ranks computed. Collective. @return number of copies near own agents that moved otherwise on their own rank,
  /// so that the outcomes of own agents may be wrong
  std::uint64_t exchangeOutcomes(World& world);

 private:
  static constexpr std::uint32_t NONE = UINT32_MAX;

  /// Finds the place of each agent on its way among the outcomes.
  void findPlaces(const World& world);

  Communicator& communicator_;
  std::vector<Shared> shared_;        // by rank; positions in place of ids
  std::vector<std::uint32_t> slots_;  // by position of the agent: its index in border_actions_, or NONE
  std::vector<RelativeAction> border_actions_;
  std::vector<std::uint32_t> places_;  // by position of the agent
  std::vector<Communicator::Bytes> out_;
  std::vector<Communicator::Bytes> in_;
};

}  // namespace crowd
