#include "common/text/yaml_reader.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace crowd::yaml_reader_test {
namespace {

const YamlPlace PLACE{"file.yaml", 2, "here"};

/// The message of the error that `action` throws; a note if it throws none.
template <typename Action>
std::string errorOf(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

std::string numberError(const std::string& text, const NumberLimit& limit = NumberRule::ANY) {
  return errorOf([&] { readNumber(YAML::Load(text), PLACE, limit); });
}

std::string wholeError(const std::string& text) {
  return errorOf([&] { readWhole(YAML::Load(text), PLACE, 1, 10); });
}

TEST(YamlPlace, NamesKeysAndElements) {
  const YamlPlace document{"f", 1, ""};
  EXPECT_EQ(document.child("agents").element(3).child("goal").path, "agents[3].goal");
}

TEST(ReadNumber, AcceptsAllNotationsOfFiniteNumbers) {
  EXPECT_EQ(readNumber(YAML::Load("-1.25"), PLACE), -1.25);
  EXPECT_EQ(readNumber(YAML::Load("+3"), PLACE), 3.0);
  EXPECT_EQ(readNumber(YAML::Load("2e-3"), PLACE), 0.002);
  EXPECT_EQ(readNumber(YAML::Load(".5"), PLACE), 0.5);
}

TEST(ReadNumber, RefusesAnythingButFiniteNumbers) {
  for (const char* text : {"fast", "1.3m", "1,3", "0x10", "nan", ".nan", "inf", ".inf", "1e999", "true", "''"}) {
    SCOPED_TRACE(text);
    EXPECT_NE(numberError(text).find("here: expected a number, got "), std::string::npos) << numberError(text);
  }
}

TEST(ReadNumber, ErrorsContainThePlaceAndTheValue) {
  EXPECT_EQ(numberError("fast"), "file.yaml: document 2, line 1: here: expected a number, got 'fast'");
  EXPECT_EQ(numberError("'1.3'"), "file.yaml: document 2, line 1: here: expected a number, got the text '1.3'");
  EXPECT_EQ(numberError("[1, 2, 3]"), "file.yaml: document 2, line 1: here: expected a number, got a list of 3");
  EXPECT_EQ(numberError("{a: 1}"), "file.yaml: document 2, line 1: here: expected a number, got a map");
  EXPECT_EQ(numberError("~"), "file.yaml: document 2, line 1: here: expected a number, got nothing");
  const YAML::Node absent(YAML::NodeType::Undefined);
  EXPECT_EQ(errorOf([&] { readNumber(absent, PLACE); }), "file.yaml: document 2: here: expected a number, got nothing");
}

TEST(ReadNumber, ErrorsShortenLongValues) { EXPECT_LT(numberError(std::string(10000, 'x')).size(), 200U); }

TEST(ReadNumber, AppliesItsRule) {
  EXPECT_EQ(readNumber(YAML::Load("0"), PLACE, NumberRule::NOT_NEGATIVE), 0.0);
  EXPECT_EQ(readNumber(YAML::Load("1e-9"), PLACE, NumberRule::POSITIVE), 1e-9);
  EXPECT_EQ(readNumber(YAML::Load("1"), PLACE, NumberRule::FRACTION), 1.0);
  EXPECT_NE(numberError("-1e-9", NumberRule::NOT_NEGATIVE).find("a number of 0 or more"), std::string::npos);
  EXPECT_NE(numberError("0", NumberRule::POSITIVE).find("a number above 0"), std::string::npos);
  EXPECT_NE(numberError("1.01", NumberRule::FRACTION).find("a number from 0 to 1"), std::string::npos);
}

TEST(ReadNumber, AppliesItsLimit) {
  constexpr NumberLimit SPEED{NumberRule::POSITIVE, 1000.0, "m/s"};
  EXPECT_EQ(readNumber(YAML::Load("1000"), PLACE, SPEED), 1000.0);
  EXPECT_EQ(numberError("1e300", SPEED), "file.yaml: document 2, line 1: here: expected at most 1000 m/s, got '1e300'");
  EXPECT_EQ(numberError("0", SPEED), "file.yaml: document 2, line 1: here: expected a number above 0, got '0'");
}

TEST(ReadWhole, AcceptsOnlyWholeNumbersWithinTheLimits) {
  EXPECT_EQ(readWhole(YAML::Load("1"), PLACE, 1, 10), 1);
  EXPECT_EQ(readWhole(YAML::Load("10"), PLACE, 1, 10), 10);
  for (const char* text : {"0", "11", "2.0", "1e0", "two", "'2'", "99999999999999999999", "[2]"}) {
    SCOPED_TRACE(text);
    EXPECT_NE(wholeError(text).find("expected a whole number from 1 to 10"), std::string::npos);
  }
}

TEST(ReadCount, AcceptsOnlyUnsigned64BitNumbers) {
  EXPECT_EQ(readCount(YAML::Load("0"), PLACE), 0U);
  EXPECT_EQ(readCount(YAML::Load("18446744073709551615"), PLACE), 18446744073709551615U);
  for (const char* text : {"-1", "18446744073709551616", "1.5", "many", "'3'"}) {
    SCOPED_TRACE(text);
    EXPECT_NE(errorOf([&] { readCount(YAML::Load(text), PLACE); }).find("expected a whole number"), std::string::npos);
  }
}

TEST(ReadVector, AcceptsOnlyTwoNumbers) {
  EXPECT_EQ(readVector(YAML::Load("[1, -2.5]"), PLACE), Eigen::Vector2d(1.0, -2.5));
  const auto error = [](const char* text) { return errorOf([&] { readVector(YAML::Load(text), PLACE); }); };
  EXPECT_NE(error("[1]").find("here: expected [x, y], got a list of 1"), std::string::npos);
  EXPECT_NE(error("[1, 2, 3]").find("here: expected [x, y], got a list of 3"), std::string::npos);
  EXPECT_NE(error("{x: 1, y: 2}").find("here: expected [x, y], got a map"), std::string::npos);
  EXPECT_NE(error("[1, up]").find("here[1]: expected a number, got 'up'"), std::string::npos);
}

TEST(ReadVector, AppliesItsLimitToBothNumbers) {
  constexpr NumberLimit PLACES{NumberRule::ANY, 10.0, "m"};
  EXPECT_EQ(readVector(YAML::Load("[10, -10]"), PLACE, PLACES), Eigen::Vector2d(10.0, -10.0));
  EXPECT_NE(errorOf([&] {
              readVector(YAML::Load("[1, -10.5]"), PLACE, PLACES);
            }).find("here[1]: expected a number from -10 to 10 m, got '-10.5'"),
            std::string::npos);
}

TEST(ReadFlag, AcceptsOnlyTrueAndFalse) {
  EXPECT_TRUE(readFlag(YAML::Load("true"), PLACE));
  EXPECT_FALSE(readFlag(YAML::Load("false"), PLACE));
  for (const char* text : {"yes", "1", "True", "'true'", "[]"}) {
    SCOPED_TRACE(text);
    EXPECT_NE(errorOf([&] { readFlag(YAML::Load(text), PLACE); }).find("true or false"), std::string::npos);
  }
}

TEST(ReadText, AcceptsOnlyScalars) {
  EXPECT_EQ(readText(YAML::Load("'two words'"), PLACE), "two words");
  EXPECT_NE(errorOf([] { readText(YAML::Load("[a]"), PLACE); }).find("expected a text"), std::string::npos);
  EXPECT_NE(errorOf([] { readText(YAML::Load("~"), PLACE); }).find("expected a text"), std::string::npos);
}

TEST(YamlMap, ReadsValuesAndUsesDefaultsForMissingKeys) {
  YamlMap map(YAML::Load("{a: 0.5, b: 3, c: word, d: true}"), PLACE);
  EXPECT_EQ(map.number("a", NumberRule::FRACTION), 0.5);
  EXPECT_EQ(map.whole("b", 0, 9), 3);
  EXPECT_EQ(map.text("c"), "word");
  EXPECT_TRUE(map.flag("d", false));
  EXPECT_EQ(map.number("e", NumberRule::ANY, 7.5), 7.5);
  EXPECT_EQ(map.whole("f", 0, 9, 4), 4);
  EXPECT_EQ(map.text("g", "other"), "other");
  EXPECT_FALSE(map.flag("h", false));
  EXPECT_FALSE(map.find("i"));
  EXPECT_TRUE(map.has("a"));
  EXPECT_FALSE(map.has("i"));
}

TEST(YamlMap, NamesAMissingKeyWithTheLineOfTheMap) {
  YamlMap map(YAML::Load("# first line\n\na: 1\nb: 2\n"), PLACE);
  EXPECT_EQ(errorOf([&] { map.need("c"); }), "file.yaml: document 2, line 3: here: the key 'c' is missing");
}

TEST(YamlMap, NamesAnUnknownKeyWithLineSuggestionAndKnownKeys) {
  const auto error = [](const char* text) {
    return errorOf([&] { YamlMap(YAML::Load(text), PLACE, {"a", "speed", "tick"}); });
  };
  EXPECT_EQ(error("a: 1\nsped: 2\n"),
            "file.yaml: document 2, line 2: here: unknown key 'sped', did you mean 'speed'? Known are a, speed, tick");
  EXPECT_EQ(error("colour: 2\na: 1\n"),
            "file.yaml: document 2, line 1: here: unknown key 'colour'; known are a, speed, tick");
  EXPECT_EQ(error("a: 1\ntick: 2\n"), "no InputError");
}

TEST(YamlMap, KeysCanBeDeclaredAfterTheFirstRead) {
  YamlMap map(YAML::Load("type: x\nsped: 2\n"), PLACE);
  EXPECT_EQ(map.text("type"), "x");
  EXPECT_NE(errorOf([&] {
              map.allow({"type", "speed"});
            }).find("did you mean 'speed'? Known are type, speed"),
            std::string::npos);
  const YamlMap misspelt(YAML::Load("a: 1\ntpye: x\n"), PLACE);
  EXPECT_EQ(errorOf([&] { misspelt.text("type"); }),
            "file.yaml: document 2, line 2: here: unknown key 'tpye', did you mean 'type'?");
}

TEST(YamlMap, ReadsOnlyDeclaredKeys) {
  const YamlMap map(YAML::Load("a: 1"), PLACE, {"a"});
  EXPECT_THROW(map.find("b"), std::logic_error);
}

TEST(YamlMap, RefusesRepeatedKeysAndAnythingButMaps) {
  EXPECT_EQ(errorOf([] { YamlMap(YAML::Load("a: 1\nb: 2\na: 3\n"), PLACE); }),
            "file.yaml: document 2, line 3: here: the key 'a' stands twice");
  EXPECT_NE(errorOf([] { YamlMap(YAML::Load("[a]"), PLACE); }).find("expected a map"), std::string::npos);
  EXPECT_NE(errorOf([] { YamlMap(YAML::Load("? [a]\n: 1"), PLACE); }).find("a word as key"), std::string::npos);
}

TEST(YamlStream, ReadsAllDocumentsWithLineNumbersOfTheWholeText) {
  const std::vector<YAML::Node> documents = parseYamlStream("# note\n---\na: 1\n---\nb: x\n", "text");
  ASSERT_EQ(documents.size(), 2U);
  YamlMap second(documents[1], {"text", 2, ""});
  EXPECT_EQ(errorOf([&] { second.number("b", NumberRule::ANY); }),
            "text: document 2, line 5: b: expected a number, got 'x'");
}

TEST(YamlStream, NamesTheLineOfASyntaxError) {
  const std::string error = errorOf([] { parseYamlStream("a: 1\nb: [1, 2\nc: 3\n", "text"); });
  EXPECT_EQ(error.find("text: line 3: this is not YAML: "), 0U) << error;
}

TEST(YamlStream, RefusesADocumentThatBeginsWithAComma) {
  const auto error = [](const char* text) { return errorOf([&] { parseYamlStream(text, "text"); }); };
  EXPECT_EQ(error("# note\n, a: 1\n"), "text: line 2: this is not YAML: a comma out of place");
  EXPECT_EQ(error("a: 1\n--- , b: 2\n"), "text: line 2: this is not YAML: a comma out of place");
  EXPECT_EQ(error("{a: 1},\n{b: 2}\n"), "text: line 1: this is not YAML: a comma out of place");
  EXPECT_EQ(error("'a' , b\n"), "text: line 1: this is not YAML: a comma out of place");
  EXPECT_EQ(error("word\n...\n  , b\n"), "text: line 3: this is not YAML: a comma out of place");
}

TEST(YamlStream, ReadsAliases) {
  const std::vector<YAML::Node> documents = parseYamlStream("a: &a [1, 2]\nb: [*a, *a]\n---\n- &a 3\n- *a\n", "text");
  ASSERT_EQ(documents.size(), 2U);
  EXPECT_EQ(documents[0]["b"][1][1].Scalar(), "2");
  EXPECT_EQ(documents[1][1].Scalar(), "3");
}

/// Three lists of 100 aliases each stand for a million elements, which readers would store.
TEST(YamlStream, RefusesAliasesThatMakeMuchOfASmallText) {
  const auto repeated = [](const std::string& word) {
    std::string list = "[" + word;
    for (int i = 1; i < 100; ++i) list += ", " + word;
    return list + "]";
  };
  std::string text = "a: &a " + repeated("1") + "\nb: &b " + repeated("*a") + "\n";
  EXPECT_EQ(parseYamlStream(text, "text").size(), 1U);
  text += "c: " + repeated("*b") + "\n";
  const std::string most = std::to_string(text.size() + 100'000);
  EXPECT_EQ(errorOf([&] { parseYamlStream(text, "text"); }),
            "text: line 3: too many aliases: expected at most " + most + " elements in place of them");
}

TEST(YamlStream, RefusesAnAliasWithinWhatItStandsFor) {
  EXPECT_EQ(errorOf([&] { parseYamlStream("a: 1\nb: &b [1, *b]\n", "text"); }),
            "text: line 2: an alias within what it stands for");
}

TEST(YamlStream, ReadsFlowMapsAndUnusualLines) {
  EXPECT_EQ(parseYamlStream("{a: 1, b: [1, 2]}\n---\na: [1\n  , 2]\n", "text").size(), 2U);
}

TEST(YamlStream, NamesAnUnreadableFile) {
  const auto error = [](const std::string& file) -> std::string {
    try {
      loadYamlStream(file);
    } catch (const FileError& failure) {
      return failure.what();
    }
    return "no FileError";
  };
  const std::string full = std::filesystem::current_path().string() + "/no/such/file.yaml";
  EXPECT_EQ(error("no/such/file.yaml"),
            "no/such/file.yaml: cannot be read: No such file or directory (that is " + full + ")");
  EXPECT_EQ(error("/no/such/file.yaml"), "/no/such/file.yaml: cannot be read: No such file or directory");
  EXPECT_EQ(error(testing::TempDir()), testing::TempDir() + ": is a folder, expected a file");
}

TEST(YamlStream, ReadsAFile) {
  const std::string file = testing::TempDir() + "social_crowd_yaml_reader_test.yaml";
  std::ofstream(file) << "a: 1\n---\na: 2\n";
  EXPECT_EQ(loadYamlStream(file).size(), 2U);
  std::remove(file.c_str());
}

}  // namespace
}  // namespace crowd::yaml_reader_test
