#include "version.h"

#include "built_version.h"

namespace crowd {

std::string versionText() { return "package " BUILT_PACKAGE "\nsources " BUILT_SOURCES "\ncompiler " BUILT_BY; }

}  // namespace crowd
