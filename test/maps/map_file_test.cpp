#include "maps/map_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/map_texts.h"

namespace crowd::map_file_test {
namespace {

using map_texts::bytes;
using map_texts::drawingOf;
using map_texts::GRAYS;
using map_texts::Keys;
using map_texts::pgmOf;

std::string drawing(const Keys& keys, const std::vector<int>& samples) {
  return drawingOf(map_texts::read(keys, pgmOf(samples)));
}

TEST(MapFile, ReadsSizeOriginAndRowsFromTheBottom) {
  const OccupancyMap map = map_texts::read(Keys(), "P5 3 2 255\n" + bytes({0, 255, 255, 255, 205, 0}));
  EXPECT_EQ(map.resolution, 0.05);
  EXPECT_EQ(map.origin.position, Vector2(-1.0, 2.0));
  EXPECT_EQ(map.origin.heading, 0.5);
  EXPECT_EQ(map.width, 3U);
  EXPECT_EQ(map.height, 2U);
  EXPECT_EQ(drawingOf(map), ".?##..");
}

TEST(MapFile, ThresholdsClassifyDarkness) {
  // Darkness: 1, 0.686, 0.502, 0.19608, 0.176, 0.
  EXPECT_EQ(drawing(Keys(), GRAYS), "##??..");
  EXPECT_EQ(drawing(Keys().set("occupied_thresh", "0.69"), GRAYS), "#???..");
  EXPECT_EQ(drawing(Keys().set("free_thresh", "0.1961"), GRAYS), "##?...");
  EXPECT_EQ(drawing(Keys().set("mode", "trinary"), GRAYS), "##??..");
}

TEST(MapFile, DarknessEqualToAThresholdIsUnknown) {
  // 204 and 51 of 255 have darkness 0.2 and 0.8, computed as (255 - 204) / 255 and (255 - 51) / 255.
  EXPECT_EQ(drawing(Keys().set("free_thresh", "0.2").set("occupied_thresh", "0.8"), {50, 51, 204, 205}), "#??.");
  EXPECT_EQ(drawing(Keys().set("free_thresh", "0").set("occupied_thresh", "1"), {0, 255}), "??");
}

TEST(MapFile, NegateExchangesBlackAndWhite) {
  // Darkness: 0, 0.314, 0.498, 0.804, 0.824, 1.
  EXPECT_EQ(drawing(Keys().set("negate", "1"), GRAYS), ".??###");
  EXPECT_EQ(drawing(Keys().set("negate", "true"), GRAYS), ".??###");
  EXPECT_EQ(drawing(Keys().set("negate", "false"), GRAYS), "##??..");
}

TEST(MapFile, ScaleModeInterpolatesBetweenTheThresholds) {
  // Thresholds 0.2 and 0.6: darkness 0.2 becomes 1 %, 0.298 25.01 %, 0.302 25.97 %, 0.306 26.9 %, 0.459 64.4 %,
  // 0.463 65.3 % and 0.6 99 %. Up to 25 % is free, and 65 % and more is occupied.
  const Keys keys = Keys().set("mode", "scale").set("free_thresh", "0.2").set("occupied_thresh", "0.6");
  EXPECT_EQ(drawing(keys, {205, 204, 179, 178, 177, 138, 137, 102, 101}), "....??###");
}

TEST(MapFile, RawModeUsesPixelsAsOccupancies) {
  const Keys keys = Keys().set("mode", "raw");
  EXPECT_EQ(drawing(keys, {0, 25, 26, 64, 65, 100, 255, 205}), "..??##??");
  EXPECT_EQ(drawing(Keys().set("mode", "raw").set("negate", "1"), {255, 230, 229, 155, 0}), "..?#?");
}

TEST(MapFile, ImageIsRelativeToTheMapFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.file("maps/images"));
  folder.write("maps/images/floor.pgm", pgmOf({0, 255}));
  const std::string relative = folder.write("maps/floor.yaml", Keys().set("image", "images/floor.pgm").text());
  EXPECT_EQ(drawingOf(readMap(relative)), "#.");
  const std::string absolute =
      folder.write("floor.yaml", Keys().set("image", folder.file("maps/images/floor.pgm")).text());
  EXPECT_EQ(drawingOf(readMap(absolute)), "#.");
}

/// The message about a map file, without the folder and name before "line".
std::string problemOf(const Keys& keys, const std::string& image = pgmOf(GRAYS)) {
  const std::string message = errorOf<InputError>([&] { map_texts::read(keys, image); });
  const std::size_t start = message.find("map.yaml: ");
  return start == std::string::npos ? message : message.substr(start + std::string("map.yaml: ").size());
}

TEST(MapFileRefusals, MissingMapFile) {
  EXPECT_TRUE(contains(errorOf<FileError>([] { readMap("/nowhere/map.yaml"); }), "/nowhere/map.yaml: cannot be read"));
}

TEST(MapFileRefusals, SeveralDocuments) {
  const TemporaryFolder folder;
  const std::string file = folder.write("map.yaml", Keys().text() + "---\n" + Keys().text());
  EXPECT_EQ(errorOf<InputError>([&] { readMap(file); }), file + ": expected one YAML document, got 2");
}

TEST(MapFileRefusals, MissingKeys) {
  for (const char* key : {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}) {
    EXPECT_EQ(problemOf(Keys().set(key, "")), "line 1: the key '" + std::string(key) + "' is missing");
  }
}

TEST(MapFileRefusals, UnknownKey) {
  const std::string problem = problemOf(Keys().set("resolution", "").set("resolutoin", "0.1"));
  EXPECT_TRUE(contains(problem, "line 6: unknown key 'resolutoin', did you mean 'resolution'?")) << problem;
}

TEST(MapFileRefusals, Resolution) {
  for (const std::string value : {"0", "-0.05", ".inf", ".nan", "wide"}) {
    EXPECT_EQ(problemOf(Keys().set("resolution", value)),
              "line 2: resolution: expected a number above 0, got '" + value + "'");
  }
}

TEST(MapFileRefusals, Origin) {
  EXPECT_EQ(problemOf(Keys().set("origin", "[1, 2]")), "line 3: origin: expected [x, y, yaw], got a list of 2");
  EXPECT_EQ(problemOf(Keys().set("origin", "here")), "line 3: origin: expected [x, y, yaw], got 'here'");
  EXPECT_EQ(problemOf(Keys().set("origin", "[1, .inf, 0]")), "line 3: origin[1]: expected a number, got '.inf'");
  EXPECT_EQ(problemOf(Keys().set("origin", "[1, 2, .nan]")), "line 3: origin[2]: expected a number, got '.nan'");
}

TEST(MapFileRefusals, OriginTooFarAway) {
  const std::string problem = problemOf(Keys().set("origin", "[1e9, 0, 0]"));
  EXPECT_TRUE(contains(problem, "line 1: the map is too far away for its resolution")) << problem;
}

TEST(MapFileRefusals, Thresholds) {
  EXPECT_EQ(problemOf(Keys().set("occupied_thresh", "1.5")),
            "line 4: occupied_thresh: expected a number from 0 to 1, got '1.5'");
  EXPECT_EQ(problemOf(Keys().set("free_thresh", "-0.1")),
            "line 5: free_thresh: expected a number from 0 to 1, got '-0.1'");
  for (const std::string value : {"0.65", "0.7"}) {
    EXPECT_EQ(problemOf(Keys().set("free_thresh", value)),
              "line 5: free_thresh: expected a number below occupied_thresh, 0.65, got '" + value + "'");
  }
}

TEST(MapFileRefusals, NegateAndMode) {
  EXPECT_EQ(problemOf(Keys().set("negate", "2")), "line 6: negate: expected 0 or 1, got '2'");
  EXPECT_EQ(problemOf(Keys().set("negate", "[0]")), "line 6: negate: expected 0 or 1, got a list of 1");
  EXPECT_EQ(problemOf(Keys().set("mode", "binary")), "line 7: mode: expected trinary, scale or raw, got 'binary'");
}

TEST(MapFileRefusals, ImageName) {
  EXPECT_EQ(problemOf(Keys().set("image", "\"\"")), "line 1: image: expected the file of an image, got the text ''");
  EXPECT_EQ(problemOf(Keys().set("image", "[a, b]")), "line 1: image: expected a text, got a list of 2");
}

TEST(MapFileRefusals, MissingImage) {
  const std::string problem = problemOf(Keys().set("image", "other.pgm"));
  EXPECT_TRUE(contains(problem, "line 1: image: /")) << problem;
  EXPECT_TRUE(contains(problem, "/other.pgm: cannot be read: No such file or directory")) << problem;
  EXPECT_TRUE(contains(problemOf(Keys().set("image", ".")), ": is a folder, expected a file"));
}

}  // namespace
}  // namespace crowd::map_file_test
