# What the program itself needs; tests/CMakeLists.txt finds what only the tests need.
# Imported targets count as system headers, so our warnings do not reach into them.

find_package(Threads REQUIRED)
find_package(glm REQUIRED)
if(KD_WITH_TBB)
    find_package(TBB REQUIRED COMPONENTS tbb)
endif()
find_package(hwy REQUIRED)
find_package(fmt REQUIRED)
find_package(PNG REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(tinyexr REQUIRED)
find_package(CLI11 REQUIRED)

# Headers only: the libraries behind them are opened at run time.
find_path(KD_GL_HEADERS GL/glcorearb.h REQUIRED)
find_path(KD_EGL_HEADERS EGL/egl.h REQUIRED)
find_path(KD_OSMESA_HEADERS GL/osmesa.h)
if(NOT KD_OSMESA_HEADERS)
    message(STATUS "GL/osmesa.h not found: no OSMesa context")
endif()

if(KD_BUILD_WINDOW)
    find_package(glfw3 3.3 REQUIRED)
    find_package(PkgConfig REQUIRED)
    pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
endif()
