#include "common/files/checksum.h"

#include <gtest/gtest.h>

namespace crowd::checksum_test {
namespace {

std::string checksumOf(std::string_view text) {
  Checksum checksum;
  checksum.add(text);
  return checksum.text();
}

// Values from the test suite of the authors of FNV.
TEST(Checksum, IsFnv1a) {
  EXPECT_EQ(checksumOf(""), "cbf29ce484222325");
  EXPECT_EQ(checksumOf("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(checksumOf("foobar"), "85944171f73967e8");
}

TEST(Checksum, OfPiecesEqualsThatOfTheWholeText) {
  Checksum checksum;
  for (const char* piece : {"fo", "", "o", "bar"}) checksum.add(piece);
  EXPECT_EQ(checksum.text(), checksumOf("foobar"));
}

TEST(Checksum, TreatsBytesAsUnsigned) {
  EXPECT_EQ(checksumOf("\xff"), "af64724c8602eb6e");  // not taken for a negative number
  EXPECT_NE(checksumOf(std::string(1, '\0')), checksumOf(""));
}

}  // namespace
}  // namespace crowd::checksum_test
