# The libraries of the core, from their sources; core.cmake finds these targets by modules/ and by the variables set here.

file(GLOB ZLIB_FILES ${SOURCES}/zlib/*.c)
list(FILTER ZLIB_FILES EXCLUDE REGEX /gz)
file(GLOB PNG_FILES ${SOURCES}/libpng/png*.c)
list(FILTER PNG_FILES EXCLUDE REGEX pngtest)
configure_file(${SOURCES}/libpng/scripts/pnglibconf.h.prebuilt ${CMAKE_BINARY_DIR}/png/pnglibconf.h COPYONLY)
add_library(png STATIC ${PNG_FILES} ${ZLIB_FILES})
target_include_directories(png SYSTEM PUBLIC ${SOURCES}/libpng ${CMAKE_BINARY_DIR}/png ${SOURCES}/zlib)
add_library(PNG::PNG ALIAS png)

file(GLOB YAML_FILES ${SOURCES}/yaml-cpp/src/*.cpp)
add_library(yaml-cpp STATIC ${YAML_FILES})
set(YAML_CPP_INCLUDE_DIR ${SOURCES}/yaml-cpp/include)
set(YAML_CPP_LIBRARIES yaml-cpp)
target_include_directories(yaml-cpp SYSTEM PUBLIC ${YAML_CPP_INCLUDE_DIR})

# Debian installs the headers of both in one folder.
file(GLOB RECAST_FILES ${SOURCES}/recastnavigation/Recast/Source/*.cpp ${SOURCES}/recastnavigation/Detour/Source/*.cpp)
file(GLOB RECAST_HEADERS ${SOURCES}/recastnavigation/Recast/Include/*.h ${SOURCES}/recastnavigation/Detour/Include/*.h)
file(COPY ${RECAST_HEADERS} DESTINATION ${CMAKE_BINARY_DIR}/recast/recastnavigation)
add_library(recast STATIC ${RECAST_FILES})
target_include_directories(recast SYSTEM PUBLIC ${CMAKE_BINARY_DIR}/recast/recastnavigation)
set(RECAST_INCLUDE_DIR ${CMAKE_BINARY_DIR}/recast)
set(RECAST_LIBRARY recast)
set(DETOUR_LIBRARY recast)
target_compile_options(recast PRIVATE -ffp-contract=off)
set_target_properties(png yaml-cpp recast PROPERTIES UNITY_BUILD OFF)  # their files do not go together
