# Run by each build in which a source has changed, after configure_file(): writes the header of version.cpp.
# The digest is the beginning of that of `sha256sum FILE...`, with the sorted names of all sources.
set(SOURCES "@PROGRAM_SOURCES@")
set(BUILD_KIND [=[@BUILD_KIND@]=])
set(SUMS "")
foreach(SOURCE IN LISTS SOURCES)
  file(SHA256 "@PROJECT_SOURCE_DIR@/${SOURCE}" SUM)
  string(APPEND SUMS "${SUM}  ${SOURCE}\n")
endforeach()
string(SHA256 DIGEST "${SUMS}")
string(SUBSTRING "${DIGEST}" 0 16 DIGEST)
file(WRITE "@BUILT_VERSION@" "#define BUILT_PACKAGE \"@social_crowd_VERSION@\"
#define BUILT_SOURCES \"${DIGEST}\"
#define BUILT_BY R\"(${BUILD_KIND})\"
")
