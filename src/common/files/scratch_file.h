#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

namespace crowd {

/// @brief A temporary file without a name, which vanishes with the object, also if the process is killed. Threads may
/// read and write different parts at the same time.
class ScratchFile {
 public:
  /// @throws FileError
  ScratchFile();
  /// @param place in the file [bytes]; what was not written before it is zero @throws FileError
  void write(std::uint64_t place, const std::vector<char>& bytes);
  /// @brief Fills `bytes` with what was written at a place. @throws FileError
  void read(std::uint64_t place, std::vector<char>& bytes) const;

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace crowd
