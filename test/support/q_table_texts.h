#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

#include "learning/q_table_file.h"

/// A small Q-table file for tests: its text and its table.
namespace crowd::q_table_texts {

/// 64-bit FNV-1a in 16 hexadecimal digits; a second implementation, for damaged files with a valid checksum.
inline std::string checksumOf(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char letter : text) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 1099511628211ULL;
  }
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

/// The text followed by the line of its checksum.
inline std::string withChecksum(const std::string& text) { return text + "checksum: " + checksumOf(text) + "\n"; }

/// Goal ahead or behind, obstacle left or right at two distances: 2 * 2 * 2 + 2 + 1 = 11 rows. The checksum is from
/// another program.
inline std::string text() {
  return "social_crowd Q-table 1\n"
         "state_set: {type: nearest_obstacle, goal_sectors: 2, obstacle_sectors: [180], collision_radius: 0.5, "
         "vision_radius: 1}\n"
         "action_set: {type: kings_moves, rotations: 2}\n"
         "reward: {goal: cosine_cubed, arrival: 100, obstacle_cost: 80}\n"
         "rows: 11\n"
         "actions: 2\n"
         "alpha: 0.1\n"
         "gamma: 0.5\n"
         "lambda: 0.25\n"
         "epsilon: 0\n"
         "decisions: 42\n"
         "seed: 7\n"
         "visited_rows: 3\n"
         "---\n"
         "0 1 0.5 0 0\n"
         "3 0 0 2 -0.125\n"
         "10 4294967295 -1.5 2 0.1\n"
         "checksum: 76724e3a93345499\n";
}

/// A text without its checksum.
inline std::string bodyOf(const std::string& text) { return text.substr(0, text.find("checksum: ")); }
inline std::string body() { return bodyOf(text()); }

/// The same table with visits of two other sources, and the name of its own source.
inline std::string textWithSources() {
  std::string all = body() +
                    "source 0000000000000011 2\n"
                    "3 0 1\n"
                    "10 5 0\n"
                    "source fedcba9876543210 1\n"
                    "10 4294967295 2\n";
  all.insert(all.find("visited_rows"), "source: '00000000000000ff'\nother_sources: 2\n");
  return withChecksum(all);
}

/// The table of text().
inline TrainedTable trained() {
  QTable table(11, 2);
  table.set(0, 0, 0.5, 1);
  table.set(3, 1, -0.125, 2);
  table.set(10, 0, -1.5, UINT32_MAX);
  table.set(10, 1, 0.1, 2);
  return {parseModel("{state_set: {type: nearest_obstacle, goal_sectors: 2, obstacle_sectors: [180]}, "
                     "action_set: {type: kings_moves, rotations: 2}, "
                     "reward: {goal: cosine_cubed, obstacle_cost: 80}}"),
          {0.1, 0.5, 0.25, 0.0},
          42,
          7,
          table};
}

/// The table of textWithSources().
inline TrainedTable trainedBySources() {
  TrainedTable all = trained();
  const auto visits = [&](std::initializer_list<std::pair<Row, std::array<std::uint32_t, 2>>> rows) {
    auto counts = std::make_shared<VisitCounts>(2);
    for (const auto& [row, of_actions] : rows) counts->add(row, of_actions.data());
    return counts;
  };
  all.table.setSources(
      0xFF, {{0x11, visits({{3, {0, 1}}, {10, {5, 0}}})}, {0xFEDCBA9876543210, visits({{10, {UINT32_MAX, 2}}})}});
  return all;
}

}  // namespace crowd::q_table_texts
