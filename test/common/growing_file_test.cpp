#include "common/files/growing_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "common/files/files.h"
#include "social_crowd/errors.h"
#include "support/file_tests.h"

namespace crowd::growing_file_test {
namespace {

using Names = std::vector<std::string>;

TEST(GrowingFile, GoesOnAfterItsFirstBytes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file");
  {
    GrowingFile grows(file, "first\n");
    grows.append("second\n");
    grows.flushToDisk();
    EXPECT_EQ(grows.size(), 13U);
    grows.append("third, cut sh");
  }
  GrowingFile grows(file, 13);
  EXPECT_EQ(readFile(file), "first\nsecond\n");
  grows.append("third\n");
  EXPECT_EQ(grows.size(), 19U);
  EXPECT_EQ(readFile(file), "first\nsecond\nthird\n");
}

TEST(GrowingFile, CannotGoOnInAMissingFile) {
  const TemporaryFolder folder;
  expectFileError(errorOf<FileError>([&] { GrowingFile(folder.file("none"), 5); }), folder.file("none"), ENOENT);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(GrowingFile, WritesIntoDevices) {
  const TemporaryFolder folder;
  const auto device = makeNullDevice(folder, "device");
  if (!device) GTEST_SKIP() << "this process may not make devices";
  const mode_t before = modeOf(*device);
  requireGrowable(*device);
  GrowingFile grows(*device, "first\n");
  grows.append("second\n");
  grows.flushToDisk();
  EXPECT_EQ(grows.size(), 13U);
  EXPECT_EQ(modeOf(*device), before);
  EXPECT_EQ(errorOf<FileError>([&] { GrowingFile(*device, 6); }),
            *device + ": cannot be written: " + std::strerror(EINVAL));
}

TEST(GrowingFile, WritesIntoPipes) {
  const TemporaryFolder folder;
  const std::string pipe = makePipe(folder, "pipe");
  requireGrowable(pipe);
  EXPECT_EQ(errorOf<FileError>([&] { GrowingFile(pipe, "first\n"); }),
            pipe + ": cannot be written: is a pipe that no process reads");
  const Descriptor reader(::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  GrowingFile grows(pipe, "first\n");
  grows.append("second\n");
  grows.flushToDisk();
  std::string got(20, ' ');
  got.resize(static_cast<std::size_t>(std::max<ssize_t>(::read(reader.number(), got.data(), got.size()), 0)));
  EXPECT_EQ(got, "first\nsecond\n");
}

TEST(GrowingFile, FollowsLinks) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("file", folder.file("link"));
  for (const std::string content : {"first", "second"}) {
    requireGrowable(folder.file("link"));
    GrowingFile(folder.file("link"), content);
    EXPECT_EQ(readFile(folder.file("file")), content);
  }
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
}

TEST(GrowingFile, GoesOnInAnOpenFileOfThisProcess) {
  const TemporaryFolder folder;
  const Descriptor opened(::open(folder.file("file").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
  ASSERT_EQ(::write(opened.number(), "before\n", 7), 7);
  GrowingFile("/dev/fd/" + std::to_string(opened.number()), "first\n").append("second\n");
  ASSERT_EQ(::write(opened.number(), "after\n", 6), 6);
  EXPECT_EQ(readFile(folder.file("file")), "before\nfirst\nsecond\nafter\n");
}

}  // namespace
}  // namespace crowd::growing_file_test
