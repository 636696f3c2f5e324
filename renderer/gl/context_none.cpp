#include "renderer/gl/context_kinds.h"

namespace kd {

namespace {

[[noreturn]] void refuse() { throw ContextError("this build has no OpenGL"); }

}  // namespace

std::unique_ptr<Context> make_osmesa_context() { refuse(); }

std::unique_ptr<Context> make_egl_context(EglDevices) { refuse(); }

}  // namespace kd
