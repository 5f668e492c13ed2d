#include "rviz/panel_texts.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr std::size_t MOST_AGENTS = 8;   // in a text
constexpr std::size_t FIRST_AGENTS = 5;  // of more of them

}  // namespace

std::string shareText(std::uint64_t count, std::uint64_t all) {
  if (all == 0) return "-";
  return std::to_string(count) + " of " + std::to_string(all) + " (" + std::to_string((200 * count + all) / (2 * all)) +
         " %)";
}

std::string agentsText(const std::vector<std::uint32_t>& agents) {
  if (agents.empty()) return "none";
  const std::size_t shown = agents.size() > MOST_AGENTS ? FIRST_AGENTS : agents.size();
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + std::to_string(agents[i]);
  return text + (shown < agents.size() ? " and " + std::to_string(agents.size() - shown) + " more" : "");
}

std::string countText(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = 3; i < text.size(); i += 4) text.insert(text.size() - i, " ");
  return text;
}

}  // namespace crowd
