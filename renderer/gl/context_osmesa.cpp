#include <array>
#include <fmt/format.h>

#include "renderer/gl/context_kinds.h"
#include "renderer/gl/shared_library.h"

namespace kd {

namespace {

// From GL/osmesa.h, which cannot be included beside GL/glcorearb.h.
constexpr int osmesa_format = 0x22;
constexpr int osmesa_depth_bits = 0x30;
constexpr int osmesa_stencil_bits = 0x31;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_major_version = 0x36;
constexpr int osmesa_minor_version = 0x37;

using Handle = struct osmesa_context*;
using CreateContext = Handle (*)(const int* attributes, Handle share);
using DestroyContext = void (*)(Handle);
using MakeCurrent = GLboolean (*)(Handle, void* buffer, GLenum type, GLsizei width, GLsizei height);
using GetProcAddress = void (*(*)(const char*))();

/// Everything is drawn into textures; OSMesa still wants a buffer to call its window.
constexpr int window_size = 16;

class OsmesaContext final : public Context {
  public:
    OsmesaContext() : Context(ContextKind::osmesa), library_("libOSMesa.so.8") {
        destroy_ = library_.function<DestroyContext>("OSMesaDestroyContext");
        make_current_ = library_.function<MakeCurrent>("OSMesaMakeCurrent");
        const auto create = library_.function<CreateContext>("OSMesaCreateContextAttribs");
        for (const GlVersion version : gl_versions) {
            // A forward-compatible context is refused by OSMesa, and not needed.
            const int attributes[] = {osmesa_format,
                                      GL_RGBA,
                                      osmesa_depth_bits,
                                      0,
                                      osmesa_stencil_bits,
                                      0,
                                      osmesa_profile,
                                      osmesa_core_profile,
                                      osmesa_major_version,
                                      version.major,
                                      osmesa_minor_version,
                                      version.minor,
                                      0};
            handle_ = create(attributes, nullptr);
            if (handle_) break;
        }
        if (!handle_) throw ContextError("libOSMesa.so.8 gives no OpenGL 4.3 core context");
        try {
            make_current();
            const auto get_proc = library_.function<GetProcAddress>("OSMesaGetProcAddress");
            load([get_proc](const char* name) { return reinterpret_cast<void*>(get_proc(name)); });
        } catch (...) {
            destroy_(handle_);
            throw;
        }
    }

    ~OsmesaContext() override { destroy_(handle_); }

    void make_current() override {
        if (!make_current_(handle_, window_.data(), GL_UNSIGNED_BYTE, window_size, window_size))
            throw ContextError("OSMesaMakeCurrent failed");
    }

  private:
    SharedLibrary library_;
    DestroyContext destroy_ = nullptr;
    MakeCurrent make_current_ = nullptr;
    Handle handle_ = nullptr;
    std::array<unsigned char, std::size_t(4) * window_size * window_size> window_{};
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace kd
