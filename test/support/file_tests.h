#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <csignal>
#include <cstring>
#include <optional>
#include <string>

#include "support/error_of.h"
#include "support/temporary_folder.h"

namespace crowd {

/// @brief During its lifetime, no file of this process can grow beyond a number of bytes; simulates a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

/// @brief Expects that a message names a file and the reason of the system.
inline void expectFileError(const std::string& message, const std::string& file, int reason) {
  EXPECT_TRUE(contains(message, file)) << message;
  EXPECT_TRUE(contains(message, std::strerror(reason))) << message;
}

/// @brief Makes a pipe in a folder. Returns its path.
inline std::string makePipe(const TemporaryFolder& folder, const std::string& name) {
  if (::mkfifo(folder.file(name).c_str(), 0600) != 0) ADD_FAILURE() << name << " cannot be made";
  return folder.file(name);
}

/// @brief Makes a device in a folder that is /dev/null under another name. Returns its path; nothing where this process
/// may not make devices.
inline std::optional<std::string> makeNullDevice(const TemporaryFolder& folder, const std::string& name) {
  constexpr int MEMORY = 1;
  constexpr int NULL_DEVICE = 3;
  const bool made = ::mknod(folder.file(name).c_str(), S_IFCHR | 0600, makedev(MEMORY, NULL_DEVICE)) == 0;
  return made ? std::optional(folder.file(name)) : std::nullopt;
}

/// @brief Type and permissions of what a name stands for; links are not followed.
inline mode_t modeOf(const std::string& file) {
  struct stat status {};
  return ::lstat(file.c_str(), &status) == 0 ? status.st_mode : 0;
}

}  // namespace crowd
