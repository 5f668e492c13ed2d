#include "common/files/library_file.h"

#include <dlfcn.h>

namespace crowd {

std::string libraryFile() {
  static const char PLACE = 0;  // an object of the library
  Dl_info info = {};
  return dladdr(&PLACE, &info) == 0 || info.dli_fname == nullptr ? "" : info.dli_fname;
}

}  // namespace crowd
