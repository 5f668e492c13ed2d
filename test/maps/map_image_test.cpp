#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/random.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/map_texts.h"
#include "support/png_texts.h"

namespace crowd::map_image_test {
namespace {

using map_texts::bytes;
using map_texts::Keys;

/// The cells of a map with this image. The format is determined by the first bytes.
std::string drawingOf(const std::string& image, const Keys& keys = Keys()) {
  return map_texts::drawingOf(map_texts::read(keys, image));
}

/// The error message about an image, without file names.
std::string problemOf(const std::string& image) {
  const std::string message = errorOf<InputError>([&] { map_texts::read(Keys(), image); });
  const std::size_t start = message.find("map.pgm: ");
  return start == std::string::npos ? message : message.substr(start + std::string("map.pgm: ").size());
}

TEST(PgmImage, TextAndBinaryFormatsGiveTheSameCells) {
  EXPECT_EQ(drawingOf("P2\n3 2\n255\n0 255 205\n255 0 0\n"), ".###.?");
  EXPECT_EQ(drawingOf("P5\n3 2\n255\n" + bytes({0, 255, 205, 255, 0, 0})), ".###.?");
}

TEST(PgmImage, CommentsAndBlanksAreSkipped) {
  EXPECT_EQ(drawingOf("P2 # a map\n# of two\r\n 2\t1 # pixels\n255 0 # one\n 255 # two"), "#.");
  EXPECT_EQ(drawingOf("P5\n# CREATOR: a scanner 0.050 m/pix\n2 1\n255\n" + bytes({'#', ' '})), "##");
}

TEST(PgmImage, BinarySamplesCanEqualBlanks) { EXPECT_EQ(drawingOf("P5 3 1 255\n" + bytes({'\n', ' ', 255})), "##."); }

TEST(PgmImage, SamplesAreScaled) {
  // 0, 5, 12 and 15 of 15 are 0, 85, 204 and 255 of 255.
  EXPECT_EQ(drawingOf("P2 4 1 15 0 5 12 15"), "##?.");
  EXPECT_EQ(drawingOf("P5 4 1 15\n" + bytes({0, 5, 12, 15})), "##?.");
  EXPECT_EQ(drawingOf("P2 2 1 1 0 1"), "#.");
}

TEST(PgmImage, SamplesOfTwoBytesHaveTheHighByteFirst) {
  EXPECT_EQ(drawingOf("P5 3 1 65535\n" + bytes({0, 255, 200, 0, 255, 0})), "#?.");
  EXPECT_EQ(drawingOf("P5 2 1 256\n" + bytes({1, 0, 0, 1})), ".#");
  EXPECT_EQ(drawingOf("P2 3 1 65535 255 51200 65535"), "#?.");
}

TEST(PgmImageRefusals, WrongFormat) {
  const std::string expected = "expected a PGM image (P2 or P5) or a PNG image, got a file of another format";
  for (const std::string image : {"", "P", "P6 1 1 255\nabc", "GIF89a", "\x89PMG"}) {
    EXPECT_EQ(problemOf(image), expected) << image;
  }
  EXPECT_EQ(problemOf("P55 1 1 255\na"), "expected P2 or P5 as the first word");
}

TEST(PgmImageRefusals, Size) {
  EXPECT_EQ(problemOf("P5 0 3 255\n"), "expected an image of at least one pixel, got 0 x 3 pixels");
  EXPECT_EQ(problemOf("P5 10001 10000 255\n"), "expected an image of up to 100000000 pixels, got 10001 x 10000 pixels");
  EXPECT_EQ(problemOf("P5 -3 3 255\n"), "width: expected a whole number from 0 to 4294967295, got '-3'");
  EXPECT_EQ(problemOf("P5 3 99999999999 255\n"),
            "height: expected a whole number from 0 to 4294967295, got '99999999999'");
  EXPECT_EQ(problemOf("P5 3"), "height: expected a whole number from 0 to 4294967295, got the end of the file");
}

/// The memory that is taken depends on the size of the file: otherwise this would be 100 MB.
TEST(PgmImageRefusals, HeaderOfMorePixelsThanTheFileContains) {
  EXPECT_EQ(problemOf("P2 10000 10000 255\n7 7"),
            "pixel 3 of 100000000: expected a whole number from 0 to 255, got the end of the file");
  EXPECT_EQ(problemOf("P5 10000 10000 255\n77"), "expected 100000000 bytes for 10000 x 10000 pixels, got 2");
}

TEST(PgmImageRefusals, GreatestValue) {
  const std::string name = "greatest value of a pixel: expected ";
  EXPECT_EQ(problemOf("P5 1 1 0\na"), name + "at least 1, got 0");
  EXPECT_EQ(problemOf("P5 1 1 65536\naa"), name + "a whole number from 0 to 65535, got '65536'");
  EXPECT_EQ(problemOf("P2 1 1 x 1"), name + "a whole number from 0 to 65535, got 'x'");
}

TEST(PgmImageRefusals, Truncated) {
  EXPECT_EQ(problemOf("P5 3 2 255\nabcde"), "expected 6 bytes for 3 x 2 pixels, got 5");
  EXPECT_EQ(problemOf("P5 3 2 256\nabcdef"), "expected 12 bytes for 3 x 2 pixels, got 6");
  EXPECT_EQ(problemOf("P5 3 2 255"), "expected 6 bytes for 3 x 2 pixels, got 0");
  EXPECT_EQ(problemOf("P2 3 2 255\n1 2 3 4 5"),
            "pixel 6 of 6: expected a whole number from 0 to 255, got the end of the file");
}

TEST(PgmImageRefusals, TooManySamples) {
  EXPECT_EQ(problemOf("P5 3 2 255\nabcdefg"), "expected 6 bytes for 3 x 2 pixels, got 7");
  EXPECT_EQ(problemOf("P2 2 1 255\n1 2 3"), "expected the end of the file after 2 x 1 pixels");
}

TEST(PgmImageRefusals, SamplesAboveTheGreatestValue) {
  EXPECT_EQ(problemOf("P2 2 1 100\n100 101"), "pixel 2 of 2: expected a whole number from 0 to 100, got '101'");
  EXPECT_EQ(problemOf("P5 2 1 100\n" + bytes({100, 101})), "pixel 2 of 2: expected a value from 0 to 100, got 101");
}

TEST(PgmImageRefusals, AnyDamageIsReportedOrHarmless) {
  const std::string whole = "P2\n# comment\n3 2\n255\n0 255 205\n255 0 0\n";
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::CONTENT, {});
    std::string image = whole;
    image[random.below(static_cast<std::uint32_t>(image.size()))] = static_cast<char>(random.below(256));
    image.resize(random.below(2) == 0 ? image.size() : random.below(static_cast<std::uint32_t>(image.size())));
    try {
      const OccupancyMap map = map_texts::read(Keys(), image);
      EXPECT_EQ(problemOf(map), "");
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(PngImage, Gray) {
  EXPECT_EQ(drawingOf(png::file(3, {bytes({0, 205, 255}), bytes({255, 210, 80})}, png::GRAY)), "..##?.");
}

TEST(PngImage, OneBitAndSixteenBitGray) {
  EXPECT_EQ(drawingOf(png::file(4, {bytes({0b10100000})}, png::GRAY, 1)), ".#.#");
  EXPECT_EQ(drawingOf(png::file(3, {bytes({0, 255, 205, 0, 255, 255})}, png::GRAY, 16)), "#?.");
}

TEST(PngImage, ColoursAreAveraged) {
  // Means 85, 170 and 255: darkness 0.667, 0.333 and 0.
  EXPECT_EQ(drawingOf(png::file(3, {bytes({255, 0, 0, 0, 255, 255, 255, 255, 255})}, png::RGB)), "#?.");
}

TEST(PngImage, PaletteGivesColours) {
  const std::string palette = png::chunk("PLTE", bytes({255, 255, 255, 0, 0, 0, 200, 200, 200}));
  EXPECT_EQ(drawingOf(png::file(3, {bytes({0, 1, 2})}, png::PALETTE, 8, palette)), ".#?");
}

TEST(PngImage, TrinaryModeAveragesTransparencyWithColours) {
  // Means of red, green, blue and opacity: 255, 191.25, 63.75 and 0; darkness 0, 0.25, 0.75 and 1.
  const std::string row = bytes({255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 255, 0, 0, 0, 0});
  EXPECT_EQ(drawingOf(png::file(4, {row}, png::RGBA)), ".?##");
  // Gray has the weight of three colours.
  EXPECT_EQ(drawingOf(png::file(4, {bytes({255, 255, 255, 0, 0, 255, 0, 0})}, png::GRAY_ALPHA)), ".?##");
}

TEST(PngImage, ScaleModeLeavesTransparentGrayUnknown) {
  // Opaque or transparent white is free and black is occupied. Gray 190, darkness 0.255, is 13 % if it is not
  // transparent.
  const std::string row = bytes({255, 255, 255, 0, 0, 0, 0, 0, 190, 190, 190, 1, 190, 190, 190, 0});
  EXPECT_EQ(drawingOf(png::file(4, {row}, png::RGBA), Keys().set("mode", "scale")), ".#.?");
}

TEST(PngImage, RawModeIgnoresTransparency) {
  const std::string row = bytes({20, 21, 22, 0, 70, 71, 72, 255});
  EXPECT_EQ(drawingOf(png::file(2, {row}, png::RGBA), Keys().set("mode", "raw")), ".#");
}

TEST(PngImageRefusals, Truncated) {
  const std::string whole = png::file(3, {bytes({0, 205, 255}), bytes({255, 210, 80})}, png::GRAY);
  ASSERT_EQ(drawingOf(whole), "..##?.");
  // All but the end mark, which is not needed.
  for (std::size_t size = 4; size < whole.size() - 17; ++size) {
    const std::string problem = problemOf(whole.substr(0, size));
    EXPECT_TRUE(contains(problem, "not a valid PNG image: ")) << size << ": " << problem;
  }
}

TEST(PngImageRefusals, Size) {
  EXPECT_TRUE(contains(problemOf(png::file(0, {""}, png::GRAY)), "not a valid PNG image: "));
  std::string wide = png::file(1, {bytes({0})}, png::GRAY);
  const std::string size = png::bigEndian(100'001) + png::bigEndian(1'000) + bytes({8, 0, 0, 0, 0});
  wide.replace(8, 25, png::chunk("IHDR", size));
  EXPECT_EQ(problemOf(wide), "expected an image of up to 100000000 pixels, got 100001 x 1000 pixels");
}

/// A PNG whose header says another size and type of pixels than it has.
std::string withHeader(std::uint32_t width, std::uint32_t height, png::ColourType type) {
  std::string image = png::file(1, {bytes({0})}, png::GRAY);
  const std::string kind = {8, static_cast<char>(type), 0, 0, 0};
  return image.replace(8, 25, png::chunk("IHDR", png::bigEndian(width) + png::bigEndian(height) + kind));
}

TEST(PngImageRefusals, HeaderOfMorePixelsThanTheFileCanContain) {
  const std::string gray = withHeader(100'000, 1'000, png::GRAY);
  EXPECT_EQ(problemOf(gray),
            "expected at least 96900 bytes for 100000 x 1000 pixels, got " + std::to_string(gray.size()));
  const std::string colour = withHeader(100'000, 1'000, png::RGBA);
  EXPECT_EQ(problemOf(colour),
            "expected at least 387597 bytes for 100000 x 1000 pixels, got " + std::to_string(colour.size()));
}

TEST(PngImageRefusals, MoreSamplesThanTheLimit) {
  const std::string padding = png::chunk("tEXt", std::string(400'000, 'x'));
  std::string image = withHeader(100'000, 1'000, png::RGBA);
  EXPECT_EQ(problemOf(image.insert(33, padding)),
            "expected an image of up to 100000000 samples, got 100000 x 1000 pixels of 4");
}

TEST(PngImageRefusals, DamagedChecksum) {
  std::string image = png::file(3, {bytes({0, 205, 255})}, png::GRAY);
  image[29] ^= 1;  // of the header
  EXPECT_TRUE(contains(problemOf(image), "not a valid PNG image: ")) << problemOf(image);
}

}  // namespace
}  // namespace crowd::map_image_test
