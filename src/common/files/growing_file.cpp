#include "common/files/growing_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <utility>

#include "common/files/file_access.h"
#include "common/files/files.h"

namespace crowd {

void requireGrowable(const std::string& file) {
  const FilePlace place = findPlace(file);
  if (!place.status) return requireReplaceable(file);
  requireWritableKind(file, place);
  if (::access(file.c_str(), W_OK) != 0) throwUnwritable(file);
}

GrowingFile::GrowingFile(std::string file, const std::string& first_line)
    : file_(std::move(file)), opened_(openForWriting(file_, O_CREAT | O_TRUNC)), is_new_(true) {
  append(first_line);
}

GrowingFile::GrowingFile(std::string file, std::uint64_t size)
    : file_(std::move(file)), opened_(openForWriting(file_, O_APPEND)), is_new_(false), size_(size) {
  if (::ftruncate(opened_.number(), static_cast<off_t>(size)) != 0) throwUnwritable(file_);
}

void GrowingFile::append(const std::string& text) {
  writeAll(opened_, text, file_);
  size_ += text.size();
}

void GrowingFile::flushToDisk() {
  crowd::flushToDisk(opened_, file_);
  if (is_new_) flushFolderOf(findPlace(file_).path, file_);
  is_new_ = false;
}

void GrowingFile::close() {
  if (!opened_.close()) throwUnwritable(file_);
}

}  // namespace crowd
