#include "common/files/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "common/files/descriptor.h"
#include "social_crowd/errors.h"
#include "support/file_tests.h"

namespace crowd::files_test {
namespace {

TEST(ReadFile, ReturnsEveryByte) {
  const TemporaryFolder folder;
  const std::string content("a\r\nb\0c\n\n\xFF", 9);
  EXPECT_EQ(readFile(folder.write("file", content)), content);
  EXPECT_EQ(readFile(folder.write("empty", "")), "");
}

TEST(ReadFile, ReadsLargeFiles) {
  const TemporaryFolder folder;
  std::string content;
  while (content.size() < 3000000) content += std::to_string(content.size()) + "\n";
  EXPECT_EQ(readFile(folder.write("file", content)), content);
}

TEST(ReadFile, NamesAMissingFile) {
  const TemporaryFolder folder;
  expectFileError(errorOf<FileError>([&] { readFile(folder.file("none")); }), folder.file("none"), ENOENT);
}

TEST(ReadFile, RefusesAFolder) {
  const TemporaryFolder folder;
  const std::string message = errorOf<FileError>([&] { readFile(folder.path()); });
  EXPECT_TRUE(contains(message, folder.path() + ": is a folder")) << message;
}

TEST(ReadFile, ReportsAReadError) {
  // Linux lets a process open its own memory, but address 0 holds nothing: reading fails with EIO.
  const std::string file = "/proc/self/mem";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "needs Linux";
  EXPECT_TRUE(contains(errorOf<FileError>([&] { readFile(file); }), file));
}

TEST(ReadFile, RefusesPipesAndDevices) {
  const TemporaryFolder folder;
  const std::string pipe = makePipe(folder, "pipe");
  EXPECT_EQ(errorOf<FileError>([&] { readFile(pipe); }), pipe + ": is a pipe, expected a file");
  for (const FileKinds kinds : {FileKinds::REGULAR, FileKinds::REGULAR_OR_PIPE}) {
    const std::string message = errorOf<FileError>([&] { readFile("/dev/zero", 1000, kinds); });
    EXPECT_EQ(message, "/dev/zero: is a device, expected a file");
  }
}

TEST(ReadFile, ReadsAPipeUntilAllHaveClosedIt) {
  const TemporaryFolder folder;
  const std::string pipe = makePipe(folder, "pipe");
  auto content = std::async(std::launch::async, [&] { return readFile(pipe, 1000, FileKinds::REGULAR_OR_PIPE); });
  {
    const Descriptor writer(::open(pipe.c_str(), O_WRONLY | O_CLOEXEC));  // waits for the reader
    ASSERT_EQ(::write(writer.number(), "first\n", 6), 6);
    const Descriptor other(::open(pipe.c_str(), O_WRONLY | O_CLOEXEC));
    ASSERT_EQ(::write(other.number(), "second\n", 7), 7);
  }
  EXPECT_EQ(content.get(), "first\nsecond\n");
}

TEST(ReadFile, ReadsAPipeThatIsClosedAlready) {
  for (const std::string text : {"", "text"}) {
    int ends[2] = {-1, -1};
    ASSERT_EQ(::pipe(ends), 0);
    const Descriptor reader(ends[0]);
    ASSERT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    ::close(ends[1]);
    const std::string name = "/proc/self/fd/" + std::to_string(reader.number());  // as of a shell's <(command)
    EXPECT_EQ(readFile(name, 1000, FileKinds::REGULAR_OR_PIPE), text);
  }
}

TEST(ReadFile, ReadsUpToASize) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "0123456789");
  EXPECT_EQ(readFile(file, 10), "0123456789");
  EXPECT_EQ(errorOf<FileError>([&] { readFile(file, 9); }), file + ": is 10 bytes, expected at most 9 bytes");
  std::filesystem::resize_file(file, 1'000'000'000'001);  // has no blocks on the disk
  EXPECT_EQ(errorOf<FileError>([&] { readFile(file, 4'000'000); }), file + ": is 1000001 MB, expected at most 4 MB");
  EXPECT_TRUE(contains(errorOf<FileError>([&] { readFile(file); }), "expected at most 16000 MB"));
}

TEST(ReadFile, EndsWhenMoreComesThanExpected) {
  // The system does not know the size of such files.
  const std::string unknown = "/proc/self/maps";
  EXPECT_EQ(errorOf<FileError>([&] { readFile(unknown, 10); }), unknown + ": has more, expected at most 10 bytes");
  const TemporaryFolder folder;
  const std::string pipe = makePipe(folder, "pipe");
  auto message = std::async(std::launch::async,
                            [&] { return errorOf<FileError>([&] { readFile(pipe, 3, FileKinds::REGULAR_OR_PIPE); }); });
  const Descriptor writer(::open(pipe.c_str(), O_WRONLY | O_CLOEXEC));
  ASSERT_EQ(::write(writer.number(), "0123", 4), 4);  // and does not close it
  EXPECT_EQ(message.get(), pipe + ": has more, expected at most 3 bytes");
}

TEST(MakeFolder, CreatesParentFolders) {
  const TemporaryFolder folder;
  makeFolder(folder.file("a/b/c"));
  EXPECT_TRUE(std::filesystem::is_directory(folder.file("a/b/c")));
  folder.write("a/file", "old");
  makeFolder(folder.file("a"));  // exists already: nothing changes
  EXPECT_EQ(readFile(folder.file("a/file")), "old");
}

TEST(MakeFolder, RefusesThePathOfAFile) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  for (const std::string& place : {folder.file("file"), folder.file("file/below")}) {
    const std::string message = errorOf<FileError>([&] { makeFolder(place); });
    EXPECT_TRUE(contains(message, place)) << message;
  }
  EXPECT_EQ(readFile(folder.file("file")), "old");
}

TEST(FullPath, IsTheSameForAllSpellings) {
  const TemporaryFolder folder;
  const std::string plain = folder.file("a");
  const std::vector<std::string> spellings = {plain, plain + "/", plain + "//.", folder.file("b/../a"),
                                              folder.file("./a/c/..")};
  for (const std::string& spelling : spellings) EXPECT_EQ(fullPath(spelling), fullPath(plain)) << spelling;
  EXPECT_NE(fullPath(folder.file("b")), fullPath(plain));
  makeFolder(plain);
  std::filesystem::create_directory_symlink(plain, folder.file("link"));
  for (const std::string& spelling : spellings) EXPECT_EQ(fullPath(spelling), fullPath(plain)) << spelling;
  EXPECT_EQ(fullPath(folder.file("link/")), fullPath(plain));
  makeFolder(folder.file("other/inner"));
  std::filesystem::create_directory_symlink(folder.file("other/inner"), folder.file("far"));
  EXPECT_EQ(fullPath(folder.file("far/../a")), fullPath(folder.file("other/a")));
  EXPECT_EQ(fullPath("a"), (std::filesystem::current_path() / "a").string());
  EXPECT_EQ(fullPath("/"), "/");
  EXPECT_EQ(fullPath(""), "");
}

TEST(StemOf, RemovesFolderAndExtension) {
  EXPECT_EQ(stemOf("a/b/circle6.yaml"), "circle6");
  EXPECT_EQ(stemOf("circle6.yaml"), "circle6");
  EXPECT_EQ(stemOf("/a.b/circle6"), "circle6");
  EXPECT_EQ(stemOf("circle6.v2.yaml"), "circle6.v2");
}

}  // namespace
}  // namespace crowd::files_test
