// The machine, as it stands in captions and reports.
#pragma once

#include <initializer_list>
#include <string>

#include "renderer/measure/measured_on.h"

namespace kd {

/// "Intel(R) Xeon(R) ...", or "unknown CPU".
[[nodiscard]] std::string cpu_model();

/// "Intel(R) Xeon(R) ..., AVX2, 2 threads": the renderer's name of the CPU tracers. 0 threads = all.
[[nodiscard]] std::string cpu_renderer(int threads);

class Context;      // renderer/gl/context.h
class FrameTracer;  // app/frame/frame_tracer.h
struct Session;     // app/session.h

/// This machine and build at this moment. `gl` is a tracer that runs on OpenGL, or null where none does.
[[nodiscard]] MeasuredOn measured_on(int threads, unsigned seed, const FrameTracer* gl = nullptr);
/// The same with what was chosen, but for the keys in `varied`; a camera must be in scene units.
[[nodiscard]] MeasuredOn measured_on(const Session& session, std::initializer_list<const char*> varied,
                                     const FrameTracer* gl = nullptr);
/// The same of a context in which nothing is timed.
[[nodiscard]] MeasuredOn measured_on(int threads, unsigned seed, const Context& gl);

/// The OpenGL that shaders ran on; of a software renderer its threads too: llvmpipe takes LP_NUM_THREADS, or one a
/// core.
void note_gl(MeasuredOn& on, const std::string& renderer, const std::string& driver, bool software);

/// InputError where the frame of a picture does not fit into this machine's memory.
void check_frame_memory(int width, int height);

}  // namespace kd
