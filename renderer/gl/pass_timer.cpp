#include "renderer/gl/pass_timer.h"

namespace kd {

namespace {

constexpr std::size_t frame_queries = 2;

double ms_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// Bits of 0 mean that the driver takes the queries and measures nothing.
bool has_timer(const GlApi& gl) {
    GLint elapsed = 0;
    GLint stamp = 0;
    gl.GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &elapsed);
    gl.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &stamp);
    return elapsed > 0 && stamp > 0;
}

}  // namespace

PassTimer::PassTimer(const GlApi& gl, bool software) : gl_(gl), by_wall_(software || !has_timer(gl)) {}

GLuint PassTimer::query(std::size_t index) {
    while (queries_.size() <= index) queries_.emplace_back(gl_);
    return queries_[index].id();
}

void PassTimer::begin_frame() {
    spans_.clear();
    if (by_wall_) {
        gl_.Finish();
        frame_begin_ = Clock::now();
    } else {
        frame_begin_ = Clock::now();
        gl_.QueryCounter(query(0), GL_TIMESTAMP);
    }
}

void PassTimer::begin(Pass pass) {
    spans_.push_back({pass, frame_queries + spans_.size()});
    if (by_wall_) {
        gl_.Finish();
        span_begin_ = Clock::now();
    } else {
        gl_.BeginQuery(GL_TIME_ELAPSED, query(spans_.back().query));
    }
}

void PassTimer::end() {
    if (by_wall_) {
        gl_.Finish();
        spans_.back().ms = ms_since(span_begin_);
    } else {
        gl_.EndQuery(GL_TIME_ELAPSED);
    }
}

double PassTimer::elapsed_ms(std::size_t first, std::size_t second) {
    GLuint64 begin = 0;
    GLuint64 finish = 0;
    gl_.GetQueryObjectui64v(query(first), GL_QUERY_RESULT, &begin);
    gl_.GetQueryObjectui64v(query(second), GL_QUERY_RESULT, &finish);
    return double(finish - begin) * 1e-6;
}

void PassTimer::end_frame(GlFrameReport& report) {
    if (by_wall_) {
        gl_.Finish();
        report.total_ms = ms_since(frame_begin_);
        report.clock = "finish + steady clock";
    } else {
        gl_.QueryCounter(query(1), GL_TIMESTAMP);
        report.total_ms = elapsed_ms(0, 1);
        report.wall_ms = ms_since(frame_begin_);  // the result waits for the GPU
        report.clock = "timer query";
    }
    for (Span& span : spans_) {
        if (!by_wall_) {
            GLuint64 ns = 0;
            gl_.GetQueryObjectui64v(query(span.query), GL_QUERY_RESULT, &ns);
            span.ms = double(ns) * 1e-6;
        }
        report.pass_ms[static_cast<std::size_t>(span.pass)] += span.ms;
    }
}

}  // namespace kd
