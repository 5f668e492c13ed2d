#include "common/text/quotes.h"

#include <gtest/gtest.h>

#include <thread>

#include "common/text/yaml_reader.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"

namespace crowd::quotes_test {
namespace {

TEST(Quotes, ShortTextsAreQuotedInFull) {
  EXPECT_EQ(inQuotes(""), "''");
  EXPECT_EQ(inQuotes("raduis"), "'raduis'");
  EXPECT_EQ(inQuotes(std::string(MAX_QUOTE, 'a')), "'" + std::string(MAX_QUOTE, 'a') + "'");
}

TEST(Quotes, LongTextsAreCut) {
  EXPECT_EQ(inQuotes(std::string(10'000'000, 'a')), "'" + std::string(MAX_QUOTE, 'a') + "...'");
  EXPECT_EQ(shortened("abcdef", 3), "abc...");
}

TEST(Quotes, NoCharacterIsCutInTwo) {
  EXPECT_EQ(shortened("ab\u00e9cd", 3), "ab...");  // two bytes
  EXPECT_EQ(shortened("ab\u00e9cd", 4), "ab\u00e9...");
  EXPECT_EQ(shortened("a\U0001F6B6b", 4), "a...");                              // four bytes
  EXPECT_EQ(shortened("\x80\x80\x80\x80\x80\x80\x80\x80", 6).size(), 3U + 3U);  // no UTF-8: cut somewhere before
}

TEST(Quotes, AreHiddenInTheThreadInWhichTheyAreToBeHidden) {
  const HiddenQuotes hidden;
  {
    const HiddenQuotes again;
    EXPECT_EQ(inQuotes("secret"), "'...'");
  }
  EXPECT_EQ(inQuotes("secret"), "'...'");
  std::string in_other_thread;
  std::thread([&] { in_other_thread = inQuotes("secret"); }).join();
  EXPECT_EQ(in_other_thread, "'secret'");
}

TEST(Quotes, AreShownAgain) {
  { const HiddenQuotes hidden; }
  EXPECT_EQ(inQuotes("secret"), "'secret'");
  EXPECT_FALSE(HiddenQuotes::areActive());
}

TEST(Quotes, ErrorsOfYamlTellNothingOfAHiddenText) {
  for (const char* const text : {"*secret", "%YAML secret\n---\na", "[secret", "\"\\secret\"", "secret: secret: secret",
                                 "!<secret", "%TAG secret\n---\na"}) {
    ASSERT_NE(errorOf<InputError>([&] { parseYamlStream(text, "file"); }), "no error") << text;
    const HiddenQuotes hidden;
    const std::string problem = errorOf<InputError>([&] { parseYamlStream(text, "file"); });
    EXPECT_FALSE(contains(problem, "secret")) << problem;
    EXPECT_TRUE(contains(problem, "file: line ")) << problem;
  }
}

TEST(RequireShort, RefusesLongTextsWithTheirLengthOnly) {
  EXPECT_NO_THROW(requireShort("gate", std::string(MAX_QUOTE, 'a')));
  EXPECT_EQ(errorOf<InputError>([] { requireShort("gate", "abcd", 3); }), "gate: expected at most 3 characters, got 4");
}

TEST(RequireFew, RefusesLongLists) {
  EXPECT_NO_THROW(requireFew("agents", 3, 3));
  EXPECT_EQ(errorOf<InputError>([] { requireFew("agents", 4, 3); }), "agents: expected at most 3 entries, got 4");
}

}  // namespace
}  // namespace crowd::quotes_test
