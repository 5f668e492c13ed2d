# The library social_crowd_core, which needs no ROS, and what it is built from. The package and the wheel include this file;
# REPOSITORY is the folder above src.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# Several sources are compiled as one, which halves the time of a build from nothing. -DCMAKE_UNITY_BUILD=OFF compiles each
# on its own, which is faster after a change of one of them.
option(CMAKE_UNITY_BUILD "Compile several sources as one" ON)

find_package(Eigen3 REQUIRED)
find_package(PNG REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(Threads REQUIRED)
# Recast and Detour find ways; Debian's package has neither a CMake nor a pkg-config file.
find_path(RECAST_INCLUDE_DIR recastnavigation/Recast.h)
find_library(RECAST_LIBRARY Recast)
find_library(DETOUR_LIBRARY Detour)
if(NOT RECAST_INCLUDE_DIR OR NOT RECAST_LIBRARY OR NOT DETOUR_LIBRARY)
  message(FATAL_ERROR
    "Recast and Detour are missing; in Debian 12 and Ubuntu from 22.04 on: apt-get install librecast-dev, else scripts/install_libraries")
endif()
# Highway is used for the kernels with vector instructions; without it, scalar kernels are built.
find_package(hwy 1.0 QUIET CONFIG)
option(SOCIAL_CROWD_HIGHWAY "Use Highway for vector instructions, if it is installed" ON)

add_library(${PROJECT_NAME}_warnings INTERFACE)
target_compile_options(${PROJECT_NAME}_warnings INTERFACE -Wall -Wextra -Wpedantic)

include_directories(${REPOSITORY}/include ${REPOSITORY}/src)
include_directories(SYSTEM ${EIGEN3_INCLUDE_DIRS} ${YAML_CPP_INCLUDE_DIR})

set(CORE_SOURCES)
foreach(LAYER avoidance common geometry learning library maps meshes navigation population robots scenario simd simulation training world)
  file(GLOB_RECURSE LAYER_SOURCES CONFIGURE_DEPENDS ${REPOSITORY}/src/${LAYER}/*.cpp)
  list(APPEND CORE_SOURCES ${LAYER_SOURCES})
endforeach()
list(FILTER CORE_SOURCES EXCLUDE REGEX "/simd/highway_kernels.cpp$")  # added below, if Highway is installed
add_library(${PROJECT_NAME}_core ${CORE_SOURCES})
# Fused operations are disabled, so that results are the same on every processor. errno and floating-point exceptions are
# not used; disabling them allows the vectorisation of loops with square roots and comparisons.
set(CORE_OPTIONS -ffp-contract=off -fno-math-errno -fno-trapping-math
  $<$<NOT:$<PLATFORM_ID:Emscripten>>:-fno-semantic-interposition>)
target_compile_options(${PROJECT_NAME}_core PRIVATE ${CORE_OPTIONS})
target_include_directories(${PROJECT_NAME}_core SYSTEM PRIVATE
  ${RECAST_INCLUDE_DIR} ${RECAST_INCLUDE_DIR}/recastnavigation)  # RecastAlloc.h includes <RecastAssert.h>
if(hwy_FOUND AND SOCIAL_CROWD_HIGHWAY)
  target_sources(${PROJECT_NAME}_core PRIVATE ${REPOSITORY}/src/simd/highway_kernels.cpp)
  set_source_files_properties(${REPOSITORY}/src/simd/kernels.cpp PROPERTIES COMPILE_DEFINITIONS CROWD_HIGHWAY)
  target_link_libraries(${PROJECT_NAME}_core PRIVATE hwy::hwy)
else()
  message(STATUS "${PROJECT_NAME}: without vector instructions, as Highway 1.0 is not installed (in Debian: libhwy-dev)")
endif()
# The kernels include themselves once for each processor. The list of state sets is often changed.
set_source_files_properties(
  ${REPOSITORY}/src/learning/states/state_set.cpp ${REPOSITORY}/src/simd/highway_kernels.cpp
  ${REPOSITORY}/src/simd/kernels.cpp ${REPOSITORY}/src/simd/reference.cpp ${REPOSITORY}/src/simd/segment_gaps.cpp
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
)
set_target_properties(${PROJECT_NAME}_core PROPERTIES UNITY_BUILD_BATCH_SIZE 44)
# Scenarios are found by name in the installed package, otherwise in the source tree. SCENARIOS_IN_PREFIX is their folder, as seen
# from one or two folders above that of the library.
if(NOT SCENARIOS_IN_SOURCE)
  set(SCENARIOS_IN_SOURCE ${REPOSITORY}/config/scenarios)
endif()
set_source_files_properties(${REPOSITORY}/src/scenario/reading/scenario_files.cpp PROPERTIES COMPILE_DEFINITIONS
  "SCENARIOS_IN_PREFIX=\"${SCENARIOS_IN_PREFIX}\";SCENARIOS_IN_SOURCE=\"${SCENARIOS_IN_SOURCE}\""
)
# Function calls within the library are direct (-Bsymbolic-functions).
target_link_libraries(${PROJECT_NAME}_core
  PUBLIC ${YAML_CPP_LIBRARIES} Threads::Threads  # for tests and programs, which include private headers
  PRIVATE PNG::PNG ${RECAST_LIBRARY} ${DETOUR_LIBRARY} ${CMAKE_DL_LIBS} ${PROJECT_NAME}_warnings
    $<$<NOT:$<PLATFORM_ID:Emscripten>>:-Wl,-Bsymbolic-functions>
)
