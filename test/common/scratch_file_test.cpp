#include "common/files/scratch_file.h"

#include <gtest/gtest.h>

#include "social_crowd/errors.h"
#include "support/error_of.h"

namespace crowd::scratch_file_test {
namespace {

std::vector<char> bytes(const std::string& text) { return {text.begin(), text.end()}; }

std::string read(const ScratchFile& file, std::uint64_t place, std::size_t size) {
  std::vector<char> found(size);
  file.read(place, found);
  return {found.begin(), found.end()};
}

TEST(ScratchFile, HasWhatWasWritten) {
  ScratchFile file;
  file.write(6, bytes("world"));
  file.write(0, bytes("hello"));
  EXPECT_EQ(read(file, 6, 5), "world");
  EXPECT_EQ(read(file, 0, 11), std::string("hello\0world", 11));
  file.write(0, bytes("HE"));
  EXPECT_EQ(read(file, 0, 5), "HEllo");
}

TEST(ScratchFile, EndsAfterTheLastByte) {
  ScratchFile file;
  file.write(0, bytes("hello"));
  EXPECT_NE(errorOf<FileError>([&] { read(file, 3, 4); }).find("cannot read a temporary file"), std::string::npos);
}

TEST(ScratchFile, FilesAreSeparate) {
  ScratchFile one;
  ScratchFile other;
  one.write(0, bytes("one"));
  other.write(0, bytes("two"));
  EXPECT_EQ(read(one, 0, 3), "one");
}

}  // namespace
}  // namespace crowd::scratch_file_test
