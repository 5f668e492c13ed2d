#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <thread>

#include "common/files/descriptor.h"
#include "common/files/file_lock.h"
#include "common/files/files.h"
#include "common/files/growing_file.h"
#include "common/files/result_file.h"
#include "social_crowd/errors.h"
#include "support/file_tests.h"

namespace crowd::replace_file_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

constexpr mode_t PERMISSIONS = 0777;

TEST(ReplaceFile, CreatesAndReplacesAFile) {
  const TemporaryFolder folder;
  const std::string content("a\r\nb\0c\n\n\xFF", 9);
  replaceFile(folder.file("file"), content);
  EXPECT_EQ(readFile(folder.file("file")), content);
  replaceFile(folder.file("file"), "short");
  EXPECT_EQ(readFile(folder.file("file")), "short");
  replaceFile(folder.file("file"), "");
  EXPECT_EQ(readFile(folder.file("file")), "");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(ReplaceFile, WritesLargeFiles) {
  const TemporaryFolder folder;
  const std::string content(5000000, 'x');
  replaceFile(folder.file("file"), content);
  EXPECT_EQ(readFile(folder.file("file")), content);
}

TEST(ReplaceFile, NamesAMissingFolder) {
  const TemporaryFolder folder;
  const std::string file = folder.file("none/file");
  const std::string message =
      file + ": cannot be written: " + std::strerror(ENOENT) + ": there is no folder " + folder.file("none");
  EXPECT_EQ(errorOf<FileError>([&] { replaceFile(file, "new"); }), message);
  EXPECT_EQ(errorOf<FileError>([&] { requireReplaceable(file); }), message);
  EXPECT_EQ(errorOf<FileError>([&] { GrowingFile(file, "new"); }), message);
  EXPECT_EQ(errorOf<FileError>([&] { ResultFile{file}; }), message);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(RequireReplaceable, WritesNothing) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  requireReplaceable(folder.file("new"));
  requireReplaceable(file);
  requireReplaceable("in_the_working_directory");
  EXPECT_EQ(readFile(file), "old");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(RequireReplaceable, RefusesAFolderAndAPathThroughAFile) {
  const TemporaryFolder folder;
  expectFileError(errorOf<FileError>([&] { requireReplaceable(folder.path()); }), folder.path(), EISDIR);
  const std::string below = folder.write("file", "old") + "/below/file";
  expectFileError(errorOf<FileError>([&] { requireReplaceable(below); }), below, ENOTDIR);
}

TEST(ReplaceFile, RefusesAPathThroughAFile) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old") + "/below";
  const std::string message = errorOf<FileError>([&] { replaceFile(file, "new"); });
  EXPECT_EQ(message, file + ": cannot be written: " + std::strerror(ENOTDIR));  // does not name the temporary file
  EXPECT_EQ(readFile(folder.file("file")), "old");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(ReplaceFile, KeepsAFolderOfThatName) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("taken"));
  folder.write("taken/file", "old");
  const std::string message = errorOf<FileError>([&] { replaceFile(folder.file("taken"), "new"); });
  EXPECT_TRUE(contains(message, folder.file("taken"))) << message;
  EXPECT_EQ(readFile(folder.file("taken/file")), "old");
  EXPECT_EQ(folder.names(), Names{"taken"});
}

TEST(ReplaceFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = errorOf<FileError>([&] { replaceFile(folder.file("file"), std::string(5000, 'x')); });
  }
  expectFileError(message, folder.file("file"), EFBIG);
  EXPECT_EQ(readFile(folder.file("file")), "old");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(ReplaceFile, KeepsTheOldFileInAFolderWithoutWritePermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  folder.write("file", "old");
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  const std::string message = errorOf<FileError>([&] { replaceFile(folder.file("file"), "new"); });
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  expectFileError(message, folder.file("file"), EACCES);
  EXPECT_EQ(readFile(folder.file("file")), "old");
  EXPECT_EQ(folder.names(), Names{"file"});
}

TEST(ReplaceFile, KeepsTheMode) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  for (const mode_t mode : {0600, 0640, 0444, 0755}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    replaceFile(file, "new");
    EXPECT_EQ(modeOf(file) & PERMISSIONS, mode);
  }
}

TEST(ReplaceFile, MakesAFileWithTheUsualMode) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(0027);
  replaceFile(folder.file("file"), "new");
  ::umask(before);
  EXPECT_EQ(modeOf(folder.file("file")) & PERMISSIONS, 0640U);
}

TEST(ReplaceFile, KeepsTheOwnerIfPermitted) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  ASSERT_EQ(::chown(file.c_str(), 4321, 1234), 0);
  replaceFile(file, "new");
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 4321U);
  EXPECT_EQ(status.st_gid, 1234U);
}

TEST(ReplaceFile, RefusesWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  const std::string pipe = makePipe(folder, "pipe");
  fs::create_symlink("pipe", folder.file("link"));
  std::vector<std::pair<std::string, std::string>> others = {{pipe, "a pipe"}, {folder.file("link"), "a pipe"}};
  if (const auto device = makeNullDevice(folder, "device")) others.emplace_back(*device, "a device");
  const Names names = folder.names();
  for (const auto& [file, kind] : others) {
    const std::string message = file + ": cannot be replaced: is " + kind + ", expected a regular file";
    const mode_t before = modeOf(file);
    EXPECT_EQ(errorOf<FileError>([&, name = file] { replaceFile(name, "new"); }), message);
    EXPECT_EQ(errorOf<FileError>([&, name = file] { requireReplaceable(name); }), message);
    EXPECT_EQ(errorOf<FileError>([&, name = file] { FileLock lock(name); }), message);
    EXPECT_EQ(modeOf(file), before);
  }
  EXPECT_EQ(folder.names(), names);
}

TEST(ReplaceFile, RefusesAnOpenFileOfThisProcess) {
  const TemporaryFolder folder;
  const Descriptor opened(::open(folder.write("file", "old").c_str(), O_RDWR | O_CLOEXEC));
  const std::string message =
      errorOf<FileError>([&] { replaceFile("/proc/self/fd/" + std::to_string(opened.number()), "new"); });
  EXPECT_TRUE(contains(message, "is an open file of this process")) << message;
  EXPECT_EQ(readFile(folder.file("file")), "old");
}

TEST(ReplaceFile, KeepsLinks) {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("elsewhere"));
  fs::create_symlink("elsewhere/file", folder.file("link"));
  fs::create_symlink(folder.file("link"), folder.file("link_to_it"));
  for (const std::string content : {"first", "second"}) {  // the first one does not exist yet
    replaceFile(folder.file("link_to_it"), content);
    EXPECT_EQ(readFile(folder.file("elsewhere/file")), content);
  }
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_TRUE(fs::is_symlink(folder.file("link_to_it")));
  EXPECT_EQ(folder.names(), (Names{"elsewhere", "link", "link_to_it"}));
}

TEST(ReplaceFile, RefusesLinksThatLeadNowhere) {
  const TemporaryFolder folder;
  fs::create_symlink("b", folder.file("a"));
  fs::create_symlink("a", folder.file("b"));
  const std::string message = errorOf<FileError>([&] { replaceFile(folder.file("a"), "new"); });
  EXPECT_TRUE(contains(message, folder.file("a") + ": cannot be")) << message;
  EXPECT_TRUE(fs::is_symlink(folder.file("a")) && fs::is_symlink(folder.file("b")));
}

TEST(ReplaceFile, WritesThroughNoLinkThatWasPutThere) {
  const TemporaryFolder folder;
  const std::string other = folder.write("other", "mine");
  // The name that was once used for the temporary file.
  const std::string guess = "file.tmp" + std::to_string(::getpid());
  fs::create_symlink("other", folder.file(guess));
  replaceFile(folder.file("file"), "new");
  EXPECT_EQ(readFile(other), "mine");
  EXPECT_EQ(folder.names(), (Names{"file", guess, "other"}));
}

TEST(ReplaceFile, RemovesWhatKilledProcessesLeft) {
  const TemporaryFolder folder;
  const std::string left = "file.social_crowd.tmpabcd0123";
  const std::string written = "file.social_crowd.tmpabcdefgh";
  const std::string link = "file.social_crowd.tmpzzzzzzzz";
  Names kept = {"file",         "file.tmp1", "file.social_crowd.tmp",
                "other" + left, left + "x",  "file.social_crowd.tmpABCDEFGH"};
  for (const std::string& name : kept) folder.write(name, "old");
  const Descriptor lock(::open(folder.write(written, "").c_str(), O_RDWR | O_CLOEXEC));
  ASSERT_EQ(::flock(lock.number(), LOCK_EX), 0);
  fs::create_symlink("file.tmp1", folder.file(link));
  kept.push_back(written);
  kept.push_back(link);
  std::sort(kept.begin(), kept.end());
  folder.write(left, "old");
  requireReplaceable(folder.file("file"));
  EXPECT_EQ(folder.names(), kept);
  folder.write(left, "old");
  replaceFile(folder.file("file"), "new");
  EXPECT_EQ(folder.names(), kept);
}

TEST(ReplaceFile, CanBeCalledByManyAtOnce) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file");
  const auto replace_often = [&](char letter) {
    for (int i = 0; i < 100; ++i) replaceFile(file, std::string(1000, letter));
  };
  std::vector<std::thread> threads;
  for (const char letter : {'a', 'b', 'c', 'd'}) threads.emplace_back(replace_often, letter);
  for (std::thread& thread : threads) thread.join();
  const std::string content = readFile(file);
  EXPECT_EQ(content, std::string(1000, content.at(0)));
  EXPECT_EQ(folder.names(), Names{"file"});
}

}  // namespace
}  // namespace crowd::replace_file_test
