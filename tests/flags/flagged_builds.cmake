# The tracer again with other flags and by another compiler, for tests/core/build_flags_test.cpp. Each build
# is a library of its own in which nothing but its function can be seen: else the linker would take the inline functions
# of one build for all. Gives kd_flagged_builds, and the table flagged_builds.inc.

add_library(kd_flagged_builds INTERFACE)
target_include_directories(kd_flagged_builds INTERFACE "${CMAKE_CURRENT_BINARY_DIR}")
set(flagged_source "${CMAKE_CURRENT_SOURCE_DIR}/flags/flagged_tracer.cpp")
set(flagged_table "// KD_FLAGGED(name, flags)\n")

# kd_flagged_build(NAME FLAGS...)
macro(kd_flagged_build name)
    set(flagged_options ${ARGN})
    add_library(kd_flags_${name} SHARED "${flagged_source}")
    target_link_libraries(kd_flags_${name} PRIVATE kd_warnings glm::glm)
    # Not kd_options, whose -ffp-contract would come last.
    target_include_directories(kd_flags_${name} PRIVATE "${PROJECT_SOURCE_DIR}")
    target_compile_definitions(kd_flags_${name} PRIVATE GLM_FORCE_INLINE KD_FLAGGED_TRACE=kd_trace_${name})
    target_compile_options(kd_flags_${name} PRIVATE ${flagged_options})
    set_target_properties(kd_flags_${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_link_libraries(kd_flagged_builds INTERFACE kd_flags_${name})
    list(JOIN flagged_options " " flagged_text)
    string(APPEND flagged_table "KD_FLAGGED(${name}, \"${flagged_text}\")\n")
endmacro()

include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-march=native KD_HAS_MARCH_NATIVE)
check_cxx_compiler_flag(-mfma KD_HAS_MFMA)
kd_flagged_build(o0 -O0 -ffp-contract=off)
kd_flagged_build(o2 -O2 -ffp-contract=off)
if(KD_HAS_MARCH_NATIVE)
    kd_flagged_build(native -O3 -march=native -ffp-contract=off)
endif()
if(KD_HAS_MFMA)
    kd_flagged_build(fused -O3 -mfma -ffp-contract=fast) # what must show
endif()

# Where there is a clang that finds this compiler's standard library; else a build must not break by it.
find_program(KD_CLANG clang++)
if(KD_CLANG AND NOT DEFINED KD_CLANG_WORKS)
    execute_process(OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE result
        COMMAND "${KD_CLANG}" -std=c++20 -fsyntax-only -DKD_FLAGGED_TRACE=kd_trace_clang -I "${PROJECT_SOURCE_DIR}"
            "${flagged_source}")
    string(COMPARE EQUAL "${result}" 0 works)
    set(KD_CLANG_WORKS ${works} CACHE INTERNAL "")
endif()
if(KD_CLANG_WORKS AND NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND NOT KD_SANITIZE)
    set(clang_flags -O3 -ffp-contract=off)
    set(clang_library "${CMAKE_CURRENT_BINARY_DIR}/libkd_flags_clang.so")
    add_custom_command(OUTPUT "${clang_library}"
        COMMAND "${KD_CLANG}" -std=c++20 ${clang_flags} -DGLM_FORCE_INLINE -DKD_FLAGGED_TRACE=kd_trace_clang
            -I "${PROJECT_SOURCE_DIR}" -fPIC -shared -fvisibility=hidden -fvisibility-inlines-hidden
            -Wl,-soname,libkd_flags_clang.so -MD -MF "${clang_library}.d" -o "${clang_library}" "${flagged_source}"
        DEPENDS "${flagged_source}"
        DEPFILE "${clang_library}.d"
        VERBATIM)
    add_custom_target(kd_flags_clang_library DEPENDS "${clang_library}")
    add_library(kd_flags_clang SHARED IMPORTED)
    set_target_properties(kd_flags_clang PROPERTIES IMPORTED_LOCATION "${clang_library}")
    add_dependencies(kd_flags_clang kd_flags_clang_library)
    target_link_libraries(kd_flagged_builds INTERFACE kd_flags_clang)
    list(JOIN clang_flags " " flagged_text)
    string(APPEND flagged_table "KD_FLAGGED(clang, \"clang++ ${flagged_text}\")\n")
endif()

file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/flagged_builds.inc" CONTENT "${flagged_table}" @ONLY)
