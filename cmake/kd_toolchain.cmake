# Compiler settings that hold for every target: standard, build type, ccache, sanitizers.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel" FORCE)
endif()

find_program(KD_CCACHE ccache)
if(KD_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${KD_CCACHE}")
endif()

# Coloured diagnostics also through Ninja, when the terminal wants them.
if(CMAKE_GENERATOR STREQUAL "Ninja" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    set(CMAKE_COLOR_DIAGNOSTICS ON)
endif()

add_link_options("LINKER:--as-needed")

if(KD_SANITIZE)
    add_compile_options(-fsanitize=${KD_SANITIZE} -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${KD_SANITIZE})
    add_compile_definitions(KD_SANITIZED=1)
    if(KD_SANITIZE MATCHES "undefined")
        add_compile_options(-fno-sanitize-recover=undefined)
    endif()
endif()
