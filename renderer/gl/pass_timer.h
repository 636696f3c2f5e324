// Time per pass by an honest clock: timer queries on hardware; on software renderers, whose timer queries mean nothing,
// and on drivers without them, glFinish and a steady clock.
#pragma once

#include <chrono>
#include <vector>

#include "renderer/gl/gl_tracer.h"
#include "renderer/gl/object.h"

namespace kd {

class PassTimer {
  public:
    PassTimer(const GlApi& gl, bool software);

    void begin_frame();
    void begin(Pass pass);
    void end();
    /// Waits for the frame and fills times and clock; a pass that ran several times gets the sum.
    void end_frame(GlFrameReport& report);

  private:
    using Clock = std::chrono::steady_clock;
    /// One timed stretch; with `query` on hardware, `ms` by the wall clock.
    struct Span {
        Pass pass;
        std::size_t query = 0;
        double ms = 0;
    };
    const GlApi& gl_;
    bool by_wall_;                  // glFinish and a steady clock
    std::vector<GlQuery> queries_;  // kept over frames: two for the frame, then one per span
    std::vector<Span> spans_;
    Clock::time_point frame_begin_, span_begin_;

    GLuint query(std::size_t index);
    [[nodiscard]] double elapsed_ms(std::size_t first, std::size_t second);
};

}  // namespace kd
