// Every kind of damage to a Q-table file is rejected with the file and the line at which it is detected.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "learning/q_table_file.h"
#include "support/error_of.h"
#include "support/q_table_texts.h"

namespace crowd::q_table_file_damage_test {
namespace {

using q_table_texts::body;
using q_table_texts::text;
using q_table_texts::textWithSources;
using q_table_texts::withChecksum;

/// Parses a text that must be rejected; anything but an InputError fails the test.
std::string errorIn(const std::string& damaged) {
  return errorOf<InputError>([&] { parseQTable(damaged, "table.txt"); });
}

/// The small file with a replaced text and a matching checksum, as in a deliberate change.
std::string edited(const std::string& part, const std::string& instead) {
  std::string edited = body();
  const std::size_t where = edited.find(part);
  if (where == std::string::npos) throw std::logic_error("there is no '" + part + "' in the file");
  return withChecksum(edited.replace(where, part.size(), instead));
}

void expectRefused(const std::string& damaged, int line, const std::string& words) {
  const std::string message = errorIn(damaged);
  EXPECT_EQ(message.rfind("table.txt: line " + std::to_string(line) + ": ", 0), 0U) << message;
  EXPECT_TRUE(contains(message, words)) << message << "\nshould say: " << words;
}

TEST(QTableDamage, UndamagedFileIsRead) {
  EXPECT_EQ(withChecksum(body()), text());
  EXPECT_EQ(errorIn(text()), "no error");
  EXPECT_EQ(errorIn(edited("seed: 7", "seed: 8")), "no error");
}

TEST(QTableDamage, InTheFirstLine) {
  expectRefused(edited("social_crowd Q-table 1", "social_crowd Q-table 2"), 1, "another version");
  expectRefused(edited("social_crowd Q-table 1", "social_crowd Q-table 1 "), 1, "expected 'social_crowd Q-table 1'");
  expectRefused(edited("social_crowd Q-table 1", "social_crowd Q-table 10"), 1, "expected");
  expectRefused(edited("social_crowd Q-table 1", "Social_crowd Q-table 1"), 1, "expected");
  expectRefused(edited("social_crowd Q-table 1\n", ""), 1, "expected");
  expectRefused("\n" + text(), 1, "expected");
  expectRefused("\xEF\xBB\xBF" + text(), 1, "expected");
  expectRefused("", 1, "expected 'social_crowd Q-table 1'");
}

TEST(QTableDamage, ErrorsQuoteNothingOfOtherFiles) {
  const std::string expected =
      "table.txt: line 1: expected 'social_crowd Q-table 1': this is no Q-table of this package, or one of another "
      "version";
  for (const std::string secret : {"password", "password\n", "social_crowd Q-table 1password\n---\n", "pass\nword\n"}) {
    EXPECT_EQ(errorIn(secret), expected);
    EXPECT_EQ(errorIn(secret + text()), expected);
  }
  EXPECT_EQ(errorIn(std::string(1000, 'x') + "\n"), expected);
  EXPECT_EQ(errorIn("social_crowd Q-table 1"), expected);
}

/// The same for the file that lists its sources.
std::string editedSources(const std::string& part, const std::string& instead) {
  std::string edited = q_table_texts::bodyOf(textWithSources());
  const std::size_t where = edited.find(part);
  if (where == std::string::npos) throw std::logic_error("there is no '" + part + "' in the file");
  return withChecksum(edited.replace(where, part.size(), instead));
}

TEST(QTableDamage, InTheNamesOfSources) {
  EXPECT_EQ(errorIn(editedSources("0000000000000011", "0000000000000012")), "no error");
  for (const char* const wrong : {"0000000000000000", "000000000000011", "00000000000000011", "000000000000001G",
                                  "000000000000001A", "-000000000000011", ""}) {
    expectRefused(editedSources("0000000000000011", wrong), 20, "expected 'source '");
    expectRefused(editedSources("00000000000000ff", wrong), 13, "source: expected 16 hexadecimal digits");
  }
  expectRefused(editedSources("fedcba9876543210", "0000000000000011"), 23, "above 0000000000000011");  // twice
  expectRefused(editedSources("fedcba9876543210", "0000000000000010"), 23, "above 0000000000000011");
  expectRefused(editedSources("fedcba9876543210", "00000000000000ff"), 23, "of its own");
  expectRefused(editedSources("source fedc", "Source fedc"), 23, "'source '");
  expectRefused(editedSources("source fedc", " source fedc"), 23, "'source '");
}

TEST(QTableDamage, InTheNumberOfSources) {
  expectRefused(editedSources("other_sources: 2", "other_sources: 1"), 23, "expected 'checksum: ");
  expectRefused(editedSources("other_sources: 2", "other_sources: 3"), 25, "expected 'source '");
  expectRefused(editedSources("other_sources: 2", "other_sources: 0"), 14, "other_sources");
  expectRefused(editedSources("other_sources: 2", "other_sources: 9999999999"), 14, "other_sources");
  expectRefused(editedSources("other_sources: 2\n", ""), 19, "expected 'checksum: ");
  expectRefused(edited("seed: 7\n", "seed: 7\nother_sources: 1\n"), 19, "expected 'source '");
}

TEST(QTableDamage, InTheVisitsOfSources) {
  expectRefused(editedSources("11 2\n", "11 1\n"), 22, "'source '");
  expectRefused(editedSources("11 2\n", "11 3\n"), 23, "a row number above 10");
  for (const char* const wrong : {"0", "-1", "x", "", "2 1", "2 ", "99999999999"}) {
    expectRefused(editedSources("11 2\n", "11 " + std::string(wrong) + "\n"), 20, "'source '");
  }
  expectRefused(editedSources("3 0 1\n10 5 0", "10 5 0\n3 0 1"), 22, "a row number above 10");
  expectRefused(editedSources("3 0 1\n", "11 0 1\n"), 21, "below 11");
  expectRefused(editedSources("3 0 1\n", "3 0 3\n"), 21, "no more than the table has");
  expectRefused(editedSources("3 0 1\n", "3 1 0\n"), 21, "no more than the table has");
  expectRefused(editedSources("10 5 0", "10 5 1"), 24, "no more than the table has");  // with the other source's 2
  expectRefused(editedSources("3 0 1\n", "3 0 0\n"), 21, "at least one visit");
  expectRefused(editedSources("3 0 1\n", "3 0 -1\n"), 21, "visits of each of 2 actions");
  expectRefused(editedSources("3 0 1\n", "3 0\n"), 21, "visits of each of 2 actions");
  expectRefused(editedSources("3 0 1\n", "3 0 1 0\n"), 21, "nothing after the last of 2 actions");
  expectRefused(editedSources("3 0 1\n", "3 0 1 \n"), 21, "nothing after the last of 2 actions");
  expectRefused(editedSources("3 0 1\n", "3 0 1\r\n"), 21, "");
  std::string changed = textWithSources();
  changed.replace(changed.find("3 0 1\n"), 6, "3 0 2\n");
  expectRefused(changed, 25, "the file was changed or damaged");
}

TEST(QTableDamage, InTheModel) {
  expectRefused(edited("nearest_obstacle", "nearest"), 2, "expected " + namesOf(stateSetTypes()) + ", got 'nearest'");
  expectRefused(edited("goal_sectors: 2", "goal_sectors: 0"), 2, "goal_sectors");
  expectRefused(edited("vision_radius: 1", "vision_radius: 0.1"), 2, "vision_radius");
  expectRefused(edited("vision_radius", "vision"), 2, "unknown key 'vision'");
  expectRefused(edited("kings_moves", "queens_moves"), 3, "expected kings_moves");
  expectRefused(edited("rotations: 2", "rotations: 1"), 3, "rotations");
  expectRefused(edited("cosine_cubed", "cosine"), 4, "reward.goal");
  expectRefused(edited("obstacle_cost: 80", "obstacle_cost: -80"), 4, "reward.obstacle_cost");
}

TEST(QTableDamage, InTheShape) {
  expectRefused(edited("rows: 11", "rows: 12"), 5, "rows: expected a whole number from 11 to 11, got '12'");
  expectRefused(edited("rows: 11", "rows: 10"), 5, "rows");
  expectRefused(edited("actions: 2", "actions: 3"), 6, "actions: expected");
  expectRefused(edited("actions: 2", "actions: two"), 6, "actions: expected");
  // The state set or action set does not fit the numbers.
  expectRefused(edited("goal_sectors: 2", "goal_sectors: 3"), 5, "rows: expected a whole number from 16 to 16");
  expectRefused(edited("rotations: 2", "rotations: 4"), 6, "actions: expected a whole number from 4 to 4");
}

TEST(QTableDamage, InTheLearningParameters) {
  expectRefused(edited("alpha: 0.1", "alpha: fast"), 7, "alpha: expected a number, got 'fast'");
  expectRefused(edited("gamma: 0.5", "gamma: nan"), 8, "gamma: expected a number");
  expectRefused(edited("decisions: 42", "decisions: -1"), 11, "decisions: expected");
  expectRefused(edited("decisions: 42", "decisions: 1.5"), 11, "decisions: expected");
  expectRefused(edited("seed: 7", "seed: -7"), 12, "seed: expected");
}

TEST(QTableDamage, InTheRangeOfTheLearningParameters) {
  expectRefused(edited("alpha: 0.1", "alpha: 0"), 7, "alpha: expected");
  expectRefused(edited("gamma: 0.5", "gamma: 1"), 8, "gamma: expected");
  expectRefused(edited("lambda: 0.25", "lambda: -1"), 9, "lambda: expected");
  expectRefused(edited("epsilon: 0", "epsilon: 2"), 10, "epsilon: expected");
}

TEST(QTableDamage, InTheKeysOfTheHeader) {
  for (const char* const key : {"state_set", "action_set", "reward", "rows", "actions", "alpha", "gamma", "lambda",
                                "epsilon", "decisions", "seed", "visited_rows"}) {
    const std::size_t begin = body().find("\n" + std::string(key) + ":") + 1;
    const std::string line = body().substr(begin, body().find('\n', begin) + 1 - begin);
    expectRefused(edited("\n" + line, "\n"), 2, "the key '" + std::string(key) + "' is missing");
    const std::string message = errorIn(edited(line, std::string(line).append(line)));
    EXPECT_TRUE(contains(message, "stands twice")) << message;
  }
  expectRefused(edited("seed: 7", "seed: 7\ncomment: nothing"), 13, "unknown key 'comment'");
}

TEST(QTableDamage, InTheYamlOfTheHeader) {
  expectRefused(edited("seed: 7", "seed: {7"), 12, "not YAML");
  expectRefused(edited("seed: 7", "seed"), 13, "not YAML");  // detected at the colon of the next line
  expectRefused(edited("rows: 11", "- rows"), 5, "not YAML");
  const std::string nothing = withChecksum("social_crowd Q-table 1\n---\n");
  EXPECT_EQ(errorIn(nothing).rfind("table.txt: line ", 0), 0U) << errorIn(nothing);
}

TEST(QTableDamage, InTheEndOfTheHeader) {
  expectRefused(edited("---\n", ""), 18, "the end of the header");  // after the checksum, in line 17
  expectRefused(edited("---\n", "----\n"), 19, "the end of the header");
}

TEST(QTableDamage, InTheNumberOfRows) {
  expectRefused(edited("visited_rows: 3", "visited_rows: 2"), 17, "expected 'checksum: ");
  expectRefused(edited("visited_rows: 3", "visited_rows: 4"), 18, "a row number above 10");
  expectRefused(edited("visited_rows: 3", "visited_rows: 12"), 13, "visited_rows: expected");
  expectRefused(edited("3 0 0 2 -0.125\n", ""), 17, "a row number above 10");
  expectRefused(edited("3 0 0 2 -0.125\n", "3 0 0 2 -0.125\n4 1 1 1 1\n"), 18, "");
  expectRefused(edited("3 0 0 2 -0.125\n", "\n"), 16, "a row number above 0");
}

TEST(QTableDamage, InTheOrderOfRows) {
  expectRefused(edited("3 0 0 2 -0.125", "0 0 0 2 -0.125"), 16, "a row number above 0 and below 11");  // repeated
  expectRefused(edited("0 1 0.5 0 0\n3 0 0 2 -0.125\n", "3 0 0 2 -0.125\n0 1 0.5 0 0\n"), 16, "above 3");
  expectRefused(edited("10 4294967295", "11 4294967295"), 17, "below 11");
  expectRefused(edited("10 4294967295", "4294967306 4294967295"), 17, "below 11");  // 10 + 2^32
  expectRefused(edited("10 4294967295", "-1 4294967295"), 17, "above 3");
}

TEST(QTableDamage, InTheNumbersOfARow) {
  for (const char* const wrong : {"nan", "-nan", "inf", "-inf", "1e999", "0x1", "1,5", "--1", "", "abc"}) {
    expectRefused(edited("-0.125", wrong), 16, "visits and a finite value");
  }
  for (const char* const wrong : {"-2", "2.0", "+2", "4294967296", "99999999999999999999", "x", ""}) {
    expectRefused(edited("2 -0.125", std::string(wrong) + " -0.125"), 16, "visits and a finite value");
  }
}

TEST(QTableDamage, InTheCountOfNumbersOfARow) {
  expectRefused(edited("3 0 0 2 -0.125", "3 0 0 2 -0.125 1"), 16, "nothing after the last of 2 actions");
  expectRefused(edited("3 0 0 2 -0.125", "3 0 0 2 -0.125 1 0.5"), 16, "nothing after the last of 2 actions");
  expectRefused(edited("3 0 0 2 -0.125", "3 0 0 2 -0.125  "), 16, "nothing after the last of 2 actions");
  expectRefused(edited("3 0 0 2 -0.125", "3 0 0 2"), 16, "visits and a finite value");
  expectRefused(edited("3 0 0 2 -0.125", "3 0 0"), 16, "visits and a finite value");
  expectRefused(edited("3 0 0 2 -0.125", "3"), 16, "visits and a finite value");
  expectRefused(edited("3 0 0 2 -0.125", "3  0 0 2 -0.125"), 16, "visits and a finite value");
  expectRefused(edited("3 0 0 2 -0.125", " 3 0 0 2 -0.125"), 16, "a row number");
  expectRefused(edited("3 0 0 2 -0.125", "3\t0 0 2 -0.125"), 16, "a row number");
  expectRefused(edited("3 0 0 2 -0.125", "3 0 0 2 -0.125\r"), 16, "");
}

TEST(QTableDamage, InTheChecksum) {
  expectRefused(body() + "checksum: 76724e3a93345498\n", 18, "the file was changed or damaged");
  expectRefused(body() + "checksum: 76724E3A93345499\n", 18, "'checksum: 76724e3a93345499'");
  expectRefused(body() + "checksum: \n", 18, "");
  expectRefused(body() + "Checksum: 76724e3a93345499\n", 18, "");
  expectRefused(body(), 18, "the end of the file");
  // A consistent change, which only the checksum detects.
  std::string changed = text();
  changed.replace(changed.find("0 1 0.5 0 0"), 11, "0 1 0.6 0 0");
  expectRefused(changed, 18, "the file was changed or damaged");
}

TEST(QTableDamage, TextAfterTheEnd) {
  for (const char* const more : {"\n", " ", "x", "---\n", "4 1 1 1 1\n", "checksum: 76724e3a93345499\n"}) {
    const std::string message = errorIn(text() + more);
    EXPECT_EQ(message.rfind("table.txt: line 1", 0), 0U) << message;
    EXPECT_TRUE(contains(message, "nothing after the checksum")) << message;
  }
  EXPECT_NE(errorIn(text() + text()), "no error");
  EXPECT_NE(errorIn(text() + std::string(1, '\0')), "no error");
}

void cutShortAnywhere(const std::string& whole) {
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string cut = whole.substr(0, length);
    const auto line = 1 + std::count(cut.begin(), cut.end(), '\n');
    const std::string message = errorIn(cut);
    // The first line that is incomplete or missing.
    ASSERT_EQ(message.rfind("table.txt: line " + std::to_string(line) + ": ", 0), 0U)
        << length << " bytes: " << message;
  }
}

TEST(QTableDamage, TruncationAtAnyByte) {
  cutShortAnywhere(text());
  cutShortAnywhere(textWithSources());
}

void oneByteChangedAnywhere(const std::string& whole) {
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    const auto change = [&](char byte) {
      if (byte == whole[i]) return;
      damaged[i] = byte;
      const std::string message = errorIn(damaged);
      EXPECT_EQ(message.rfind("table.txt: ", 0), 0U)
          << "byte " << i << ", '" << whole[i] << "' made '" << byte << "': " << message;
    };
    for (unsigned bit = 0; bit < 8; ++bit) change(static_cast<char>(whole[i] ^ (1 << bit)));
    for (const char byte : {'\n', '\0', ' ', '0', '9', ':', '{', '&', '*', '!', '#', '%', '"', '-'}) change(byte);
  }
}

TEST(QTableDamage, ChangeOfAnyByte) {
  oneByteChangedAnywhere(text());
  oneByteChangedAnywhere(textWithSources());
}

void oneByteMissingOrTooMuchAnywhere(const std::string& whole) {
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_NE(errorIn(std::string(whole).erase(i, 1)), "no error") << "without byte " << i;
    for (const char byte : {'0', ' ', '\n', '-'}) {
      EXPECT_NE(errorIn(std::string(whole).insert(i, 1, byte)), "no error") << "'" << byte << "' before byte " << i;
    }
  }
}

TEST(QTableDamage, RemovalOrInsertionOfAnyByte) {
  oneByteMissingOrTooMuchAnywhere(text());
  oneByteMissingOrTooMuchAnywhere(textWithSources());
}

}  // namespace
}  // namespace crowd::q_table_file_damage_test
