#include "renderer/gl/shared_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "renderer/gl/context.h"

namespace kd {

SharedLibrary::SharedLibrary(const char* file)
    : file_(file), handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
    if (!handle_) throw ContextError(fmt::format("{} cannot be loaded: {}", file, dlerror()));
}

void* SharedLibrary::symbol(const char* name) const {
    void* found = dlsym(handle_, name);
    if (!found) throw ContextError(fmt::format("{} has no function {}", file_, name));
    return found;
}

}  // namespace kd
