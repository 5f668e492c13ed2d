# Built by libraries.cmake.
set(PNG_FOUND TRUE)
