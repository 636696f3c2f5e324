#include "renderer/gl/context.h"

#include <array>
#include <cctype>
#include <fmt/format.h>

#include "renderer/gl/context_kinds.h"
#include "renderer/gl/fault.h"

namespace kd {

namespace {

constexpr std::array<std::string_view, 4> kind_names{"auto", "osmesa", "egl", "adopted"};

bool is_software_renderer(std::string_view renderer) {
    std::string lower(renderer);
    for (char& c : lower) c = char(std::tolower(static_cast<unsigned char>(c)));
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "swr", "software rasterizer", "swiftshader"})
        if (lower.find(name) != std::string::npos) return true;
    return false;
}

/// The first way that works; ContextError listing every reason where none does.
template <class... Ways>
std::unique_ptr<Context> first_of(std::string& reasons, const Ways&... ways) {
    std::unique_ptr<Context> context;
    const auto attempt = [&](const auto& way) {
        if (context) return;
        try {
            context = way();
        } catch (const ContextError& error) {
            reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", error.what());
        }
    };
    (attempt(ways), ...);
    return context;
}

}  // namespace

std::string_view name_of(ContextKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::unique_ptr<Context> Context::create(ContextKind kind) {
    std::string reasons;
    std::unique_ptr<Context> context;
    const char* remedy = "use --tracer cpu";
    switch (kind) {
        case ContextKind::automatic:
            context = first_of(
                reasons, [] { return make_egl_context(EglDevices::hardware); }, make_osmesa_context,
                [] { return make_egl_context(EglDevices::software); });
            remedy =
                "install a driver with OpenGL 4.3, libosmesa6 or libegl1 with libgl1-mesa-dri, or use --tracer cpu";
            break;
        case ContextKind::osmesa:
            context = first_of(reasons, make_osmesa_context);
            remedy = "install libosmesa6 (Mesa before 25.1), or use --context egl or --tracer cpu";
            break;
        case ContextKind::egl:
            context = first_of(reasons, [] { return make_egl_context(EglDevices::hardware_first); });
            remedy = "install libegl1 with a driver (libgl1-mesa-dri), or use --context osmesa or --tracer cpu";
            break;
        case ContextKind::adopted: reasons = "a window's context is adopted, not created"; break;
    }
    if (!context) throw ContextError(fmt::format("no OpenGL context ({}): {}; {}", name_of(kind), reasons, remedy));
    return context;
}

void Context::load(GlApi::GetProc get_proc) {
    const std::vector<std::string> missing = gl_.load(get_proc);
    if (gl_.GetString) {
        const auto text = [&](GLenum name) {
            const GLubyte* s = gl_.GetString(name);
            return std::string(s ? reinterpret_cast<const char*>(s) : "");
        };
        renderer_ = text(GL_RENDERER);
        version_ = text(GL_VERSION);
    }
    software_ = is_software_renderer(renderer_);

    int major = 0;
    int minor = 0;
    if (gl_.GetIntegerv) {
        gl_.GetIntegerv(GL_MAJOR_VERSION, &major);
        gl_.GetIntegerv(GL_MINOR_VERSION, &minor);
    }
    if (major < 4 || (major == 4 && minor < 3))
        throw ContextError(fmt::format("OpenGL 4.3 is needed, this is '{}' on '{}'", version_, renderer_));
    if (!missing.empty())
        throw ContextError(fmt::format("{} on '{}' lacks {} of its functions, first {}", version_, renderer_,
                                       missing.size(), missing.front()));
    if (10 * major + minor >= 45)
        gl_.GetGraphicsResetStatus =
            reinterpret_cast<PFNGLGETGRAPHICSRESETSTATUSPROC>(get_proc("glGetGraphicsResetStatus"));
    inject_faults(gl_);
    if (wants_gl_messages()) collect_gl_messages(gl_, messages_);
}

}  // namespace kd
