# kd_shader_text: every file under shaders/ as a table (path, text), declared in renderer/gl/shader_text.h.
# The table is written again whenever a shader changes, comes or goes.

file(GLOB_RECURSE shader_files CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/shaders" "${PROJECT_SOURCE_DIR}/shaders/*")
list(FILTER shader_files EXCLUDE REGEX "(^|/)\\.|~$|\\.(md|orig|rej|bak)$")
list(SORT shader_files)
list(TRANSFORM shader_files PREPEND "${PROJECT_SOURCE_DIR}/shaders/" OUTPUT_VARIABLE shader_paths)

set(shader_list "${PROJECT_BINARY_DIR}/generated/shader_files.txt")
set(shader_text "${PROJECT_BINARY_DIR}/generated/shader_text.cpp")
string(JOIN "\n" shader_list_text ${shader_files})
file(CONFIGURE OUTPUT "${shader_list}" CONTENT "${shader_list_text}" @ONLY) # written only when it differs

add_custom_command(
    OUTPUT "${shader_text}"
    COMMAND "${CMAKE_COMMAND}" "-DROOT=${PROJECT_SOURCE_DIR}/shaders" "-DLIST=${shader_list}" "-DOUTPUT=${shader_text}"
            -P "${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake"
    DEPENDS ${shader_paths} "${shader_list}" "${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake"
    COMMENT "Embedding shaders"
    VERBATIM)

kd_library(kd_shader_text SOURCES "${shader_text}")
