# cmake -DSOURCE_DIR= -DOUTPUT= -DVERSION= -DCOMPILER= -DFLAGS= -DBUILD_TYPE= -P write_version.cmake
# Writes version.h, touching the file only when its text changes.

set(COMMIT "unknown")
find_program(GIT git)
if(GIT AND EXISTS "${SOURCE_DIR}/.git")
    set(git "${GIT}" --no-optional-locks -C "${SOURCE_DIR}")
    execute_process(COMMAND ${git} rev-parse --short=12 HEAD
        OUTPUT_VARIABLE commit ERROR_QUIET RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(status EQUAL 0 AND commit)
        set(COMMIT "${commit}")
        execute_process(COMMAND ${git} status --porcelain --untracked-files=no
            OUTPUT_VARIABLE changes ERROR_QUIET)
        if(changes)
            string(APPEND COMMIT "-dirty")
        endif()
    endif()
endif()

foreach(value VERSION COMMIT COMPILER FLAGS BUILD_TYPE)
    string(REGEX REPLACE "([\\\"])" "\\\\\\1" ${value} "${${value}}")
endforeach()
configure_file("${CMAKE_CURRENT_LIST_DIR}/version.h.in" "${OUTPUT}" @ONLY)
