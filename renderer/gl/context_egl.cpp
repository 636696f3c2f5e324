#define EGL_EGL_PROTOTYPES 0
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

#include "renderer/gl/context_kinds.h"
#include "renderer/gl/shared_library.h"

namespace kd {

namespace {

bool has_word(const char* list, std::string_view word) {
    std::string_view rest(list ? list : "");
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == word) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

/// The functions of libEGL that are used.
struct Egl {
    SharedLibrary library{"libEGL.so.1"};
    PFNEGLGETPROCADDRESSPROC GetProcAddress = library.function<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress");
    PFNEGLQUERYSTRINGPROC QueryString = library.function<PFNEGLQUERYSTRINGPROC>("eglQueryString");
    PFNEGLINITIALIZEPROC Initialize = library.function<PFNEGLINITIALIZEPROC>("eglInitialize");
    PFNEGLBINDAPIPROC BindAPI = library.function<PFNEGLBINDAPIPROC>("eglBindAPI");
    PFNEGLCHOOSECONFIGPROC ChooseConfig = library.function<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig");
    PFNEGLCREATECONTEXTPROC CreateContext = library.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext");
    PFNEGLDESTROYCONTEXTPROC DestroyContext = library.function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext");
    PFNEGLMAKECURRENTPROC MakeCurrent = library.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
    PFNEGLGETCURRENTCONTEXTPROC GetCurrentContext =
        library.function<PFNEGLGETCURRENTCONTEXTPROC>("eglGetCurrentContext");

    template <class Function>
    [[nodiscard]] Function extension(const char* name) const {
        return reinterpret_cast<Function>(GetProcAddress(name));
    }
};

/// A display and whether software draws it.
struct Candidate {
    EGLDisplay display;
    bool software;
};

/// Displays of all devices, hardware first, then Mesa's own surfaceless one where there are no devices to choose from.
std::vector<Candidate> find_displays(const Egl& egl) {
    std::vector<Candidate> found;
    const char* extensions = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto get_display = egl.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (!get_display) return found;

    const auto query_devices = egl.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto query_device = egl.extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    if (query_devices && query_device) {
        EGLint count = 0;
        query_devices(0, nullptr, &count);
        std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(std::max(count, 0)));
        if (!query_devices(count, devices.data(), &count)) count = 0;
        devices.resize(static_cast<std::size_t>(count));
        for (const EGLDeviceEXT device : devices) {
            const bool software = has_word(query_device(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
            found.push_back({get_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr), software});
        }
    }
    std::ranges::stable_partition(found, [](const Candidate& c) { return !c.software; });
    if (has_word(extensions, "EGL_MESA_platform_surfaceless"))
        found.push_back({get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), true});
    std::erase_if(found, [](const Candidate& c) { return c.display == EGL_NO_DISPLAY; });
    return found;
}

/// A core context of the best version that `display` gives, or EGL_NO_CONTEXT.
EGLContext create_on(const Egl& egl, EGLDisplay display) {
    if (!egl.Initialize(display, nullptr, nullptr)) return EGL_NO_CONTEXT;
    if (!egl.BindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    if (!has_word(egl.QueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) return EGL_NO_CONTEXT;

    // Any surface type will do (0): there is none.
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl.ChooseConfig(display, wanted, &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;

    for (const GlVersion version : gl_versions)
        for (const bool robust : {true, false}) {
            std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,       version.major,
                                           EGL_CONTEXT_MINOR_VERSION,       version.minor,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
            // Tells when the GPU was reset, and reads nothing of others beyond the end of a buffer. Not all drivers
            // can.
            if (robust)
                attributes.insert(attributes.end(),
                                  {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET,
                                   EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE});
            attributes.push_back(EGL_NONE);
            if (EGLContext context = egl.CreateContext(display, config, EGL_NO_CONTEXT, attributes.data()))
                return context;
        }
    return EGL_NO_CONTEXT;
}

/// Its display is never terminated: displays belong to the process, and another context may use the same one.
class EglContext final : public Context {
  public:
    EglContext(const Egl& egl, const Candidate& candidate)
        : Context(ContextKind::egl), egl_(egl), display_(candidate.display),
          handle_(create_on(egl, candidate.display)) {
        if (handle_ == EGL_NO_CONTEXT) throw ContextError("an EGL device gives no surfaceless OpenGL 4.3 core context");
        try {
            make_current();
            load([this](const char* name) { return reinterpret_cast<void*>(egl_.GetProcAddress(name)); });
        } catch (...) {
            destroy();
            throw;
        }
    }

    ~EglContext() override { destroy(); }

    void make_current() override {
        // Let go first: EGL passes over a call that changes nothing, also where another library took the thread since.
        release();
        if (!egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_))
            throw ContextError("eglMakeCurrent failed");
    }

  private:
    Egl egl_;
    EGLDisplay display_;
    EGLContext handle_;

    void release() {
        if (egl_.GetCurrentContext() == handle_)
            egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    void destroy() {
        release();
        egl_.DestroyContext(display_, handle_);
    }
};

}  // namespace

std::unique_ptr<Context> make_egl_context(EglDevices devices) {
    const Egl egl;
    std::string reasons;
    for (const Candidate& candidate : find_displays(egl)) {
        if (devices == EglDevices::hardware && candidate.software) continue;
        if (devices == EglDevices::software && !candidate.software) continue;
        try {
            auto context = std::make_unique<EglContext>(egl, candidate);
            // A device node without its driver falls back to software silently.
            if (devices != EglDevices::hardware || !context->is_software()) return context;
        } catch (const ContextError& error) {
            reasons += fmt::format(" ({})", error.what());
        }
    }
    throw ContextError(fmt::format("EGL has no {}device that works{}",
                                   devices == EglDevices::hardware   ? "hardware "
                                   : devices == EglDevices::software ? "software "
                                                                     : "",
                                   reasons));
}

}  // namespace kd
