#include "renderer/gl/gl_api.h"

namespace kd {

namespace {

/// True where found.
template <class Function>
bool find(const GlApi::GetProc& get_proc, const char* name, Function& function) {
    function = reinterpret_cast<Function>(get_proc(name));
    return function != nullptr;
}

}  // namespace

std::vector<std::string> GlApi::load(const GetProc& get_proc) {
    std::vector<std::string> missing;
#define KD_GL_LOAD(name, NAME)                                                                                         \
    if (!find(get_proc, "gl" #name, name)) missing.emplace_back("gl" #name);
    KD_GL_FUNCTIONS(KD_GL_LOAD)
#undef KD_GL_LOAD
    return missing;
}

}  // namespace kd
