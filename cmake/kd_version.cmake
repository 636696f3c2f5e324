# kd_version: the header "version.h" (version, commit, compiler, flags), brought up to date by every build.

string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type_upper)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type_upper}} -ffp-contract=off" build_flags)
if(KD_SANITIZE)
    string(APPEND build_flags " -fsanitize=${KD_SANITIZE}")
endif()

add_custom_target(kd_version_header
    COMMAND "${CMAKE_COMMAND}" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}" "-DOUTPUT=${PROJECT_BINARY_DIR}/app/version.h"
            "-DVERSION=${PROJECT_VERSION}" "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
            "-DFLAGS=${build_flags}" "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}"
            -P "${PROJECT_SOURCE_DIR}/cmake/write_version.cmake"
    BYPRODUCTS "${PROJECT_BINARY_DIR}/app/version.h"
    COMMENT "Checking version.h"
    VERBATIM)

add_library(kd_version INTERFACE)
target_include_directories(kd_version INTERFACE "${PROJECT_BINARY_DIR}/app")
add_dependencies(kd_version kd_version_header)
