# Built by libraries.cmake.
set(yaml-cpp_FOUND TRUE)
