# kd_library() and kd_executable(): targets of this project, with its warnings, options and include root.

set(kd_werror_default OFF)
# Warnings are errors with the compiler they are tuned for; another compiler must not fail a user's build.
if(PROJECT_IS_TOP_LEVEL AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    set(kd_werror_default ON)
endif()
option(KD_WERROR "Treat warnings in our own code as errors" ${kd_werror_default})

add_library(kd_warnings INTERFACE)
target_compile_options(kd_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(KD_WERROR)
    # Warnings that g++ 12 derives from inlined standard library code are often false: shown, never fatal.
    target_compile_options(kd_warnings INTERFACE -Werror
        $<$<CXX_COMPILER_ID:GNU>:-Wno-error=array-bounds -Wno-error=maybe-uninitialized
        -Wno-error=stringop-overflow -Wno-error=stringop-overread -Wno-error=free-nonheap-object>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(kd_warnings INTERFACE -Wno-restrict) # GCC bug 105329
endif()

# The same floating-point operations in every build: no fused multiply-add unless written.
add_library(kd_options INTERFACE)
target_compile_options(kd_options INTERFACE -ffp-contract=off)
# GLM's functions must go into callers compiled for a wider instruction set; g++ leaves some outside unless told.
target_compile_definitions(kd_options INTERFACE GLM_FORCE_INLINE)
target_include_directories(kd_options INTERFACE "${PROJECT_SOURCE_DIR}")

# kd_glob_sources(OUT FOLDERS... [EXCLUDE files...]): the .cpp files right in each folder, watched for new ones.
function(kd_glob_sources out)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FOLDERS;EXCLUDE")
    set(sources "")
    foreach(folder IN LISTS arg_FOLDERS)
        file(GLOB found CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${folder}/*.cpp")
        list(APPEND sources ${found})
    endforeach()
    foreach(file IN LISTS arg_EXCLUDE)
        list(REMOVE_ITEM sources "${PROJECT_SOURCE_DIR}/${file}")
    endforeach()
    set(${out} "${sources}" PARENT_SCOPE)
endfunction()

# kd_library(NAME [FOLDERS ...] [EXCLUDE ...] [SOURCES ...] [LINKS public...] [PRIVATE_LINKS ...]
#            [DEFINES public...] [PRIVATE_DEFINES ...])
# A library whose folders hold no source yet becomes an INTERFACE library.
function(kd_library name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" ""
        "FOLDERS;EXCLUDE;SOURCES;LINKS;PRIVATE_LINKS;DEFINES;PRIVATE_DEFINES")
    kd_glob_sources(sources FOLDERS ${arg_FOLDERS} EXCLUDE ${arg_EXCLUDE})
    list(APPEND sources ${arg_SOURCES})
    if(sources)
        add_library(${name} STATIC ${sources})
        target_link_libraries(${name} PUBLIC kd_options ${arg_LINKS} PRIVATE kd_warnings ${arg_PRIVATE_LINKS})
        target_compile_definitions(${name} PUBLIC ${arg_DEFINES} PRIVATE ${arg_PRIVATE_DEFINES})
    else()
        message(STATUS "${name}: no source yet")
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE kd_options ${arg_LINKS} ${arg_PRIVATE_LINKS})
        target_compile_definitions(${name} INTERFACE ${arg_DEFINES})
    endif()
endfunction()

# kd_executable(NAME SOURCES files... [LINKS ...] [DEFINES ...]): built into the root of the build folder;
# left out while none of its sources exists.
function(kd_executable name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS;DEFINES")
    set(sources "")
    foreach(file IN LISTS arg_SOURCES)
        cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
        file(GLOB found CONFIGURE_DEPENDS "${file}")
        list(APPEND sources ${found})
    endforeach()
    if(NOT sources)
        message(STATUS "${name}: no source yet")
        return()
    endif()
    add_executable(${name} ${sources})
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")
    target_link_libraries(${name} PRIVATE kd_options kd_warnings ${arg_LINKS})
    target_compile_definitions(${name} PRIVATE ${arg_DEFINES})
endfunction()
