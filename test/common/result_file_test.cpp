#include "common/files/result_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#include "common/files/files.h"
#include "social_crowd/errors.h"
#include "support/file_tests.h"

namespace crowd::result_file_test {
namespace {

using Names = std::vector<std::string>;

TEST(ResultFile, KeepsTheOldFileUntilItIsWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  {
    ResultFile result(file);
    EXPECT_FALSE(result.isStream());
    result.reserve(100'000);
    EXPECT_EQ(readFile(file), "old");
    EXPECT_EQ(folder.names(), Names{"file"});
  }
  EXPECT_EQ(readFile(file), "old");
  ResultFile(file).write("new");
  EXPECT_EQ(readFile(file), "new");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(ResultFile, IsNotLimitedByTheSizeThatIsReserved) {
  const TemporaryFolder folder;
  ResultFile result(folder.file("file"));
  {
    const FileSizeLimit limit(1000);  // a process that asks for more is ended, unless it ignores the signal
    std::signal(SIGXFSZ, SIG_DFL);
    result.reserve(5000);
  }
  result.write(std::string(10'000, 'x'));
  EXPECT_EQ(readFile(folder.file("file")).size(), 10'000U);
}

TEST(ResultFile, WritesIntoAPipeThatIsReadFromTheStart) {
  const TemporaryFolder folder;
  const std::string pipe = makePipe(folder, "pipe");
  EXPECT_EQ(errorOf<FileError>([&] { ResultFile{pipe}; }),
            pipe + ": cannot be written: is a pipe that no process reads");
  const Descriptor reader(::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  ResultFile result(pipe);
  EXPECT_TRUE(result.isStream());
  char letter = ' ';
  EXPECT_EQ(::read(reader.number(), &letter, 1), -1);  // nothing yet, and not its end
  EXPECT_EQ(errno, EAGAIN);
  result.write("a");
  EXPECT_EQ(::read(reader.number(), &letter, 1), 1);
  EXPECT_EQ(::read(reader.number(), &letter, 1), 0);  // its end
  EXPECT_EQ(letter, 'a');
  EXPECT_EQ(folder.names(), Names{"pipe"});
}

TEST(ResultFile, WritesIntoADevice) {
  const TemporaryFolder folder;
  const auto device = makeNullDevice(folder, "device");
  if (!device) GTEST_SKIP() << "this process may not make devices";
  const mode_t before = modeOf(*device);
  ResultFile(*device).write("new");
  EXPECT_EQ(modeOf(*device), before);
  EXPECT_EQ(folder.names(), Names{"device"});
}

TEST(ResultFile, RefusesFoldersAndSockets) {
  const TemporaryFolder folder;
  expectFileError(errorOf<FileError>([&] { ResultFile{folder.path()}; }), folder.path(), EISDIR);
  const std::string socket = folder.file("socket");
  if (::mknod(socket.c_str(), S_IFSOCK | 0600, 0) != 0) GTEST_SKIP() << "there are no sockets in this folder";
  EXPECT_EQ(errorOf<FileError>([&] { ResultFile{socket}; }), socket + ": cannot be written: is a socket");
}

}  // namespace
}  // namespace crowd::result_file_test
