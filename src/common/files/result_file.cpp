#include "common/files/result_file.h"

#include <utility>

#include "common/files/file_access.h"
#include "common/files/files.h"
#include "common/files/temporary_file.h"

namespace crowd {

ResultFile::ResultFile(std::string file) : file_(std::move(file)) {
  const FilePlace place = findPlace(file_);
  requireWritableKind(file_, place);
  if (place.isStream()) {
    stream_ = openForWriting(file_, 0);
  } else {
    requireReplaceable(file_);
  }
}

void ResultFile::reserve(std::uint64_t bytes) {
  if (!isStream()) reserve_ = reserveSpace(file_, bytes);
}

void ResultFile::write(const std::string& result) {
  if (isStream()) {
    writeAll(stream_, result, file_);
    if (!stream_.close()) throwUnwritable(file_);
  } else {
    reserve_.close();
    replaceFile(file_, result);
  }
}

}  // namespace crowd
