#include <bit>

#include "renderer/gl/gl_tracer_impl.h"
#include "renderer/gl/state_guard.h"
#include "renderer/gl/target_reader.h"

namespace kd {

Frame GlTracer::read_frame(const TraceConfig& config) {
    Impl& t = *impl_;
    const TargetKey& key = t.targets.key();
    Frame frame(key.width, key.height);
    if (frame.colour.empty()) return frame;
    frame.exponent = t.scene().scene().exponent;
    const StateGuard guard(t.gl);
    const TargetReader reader(t.gl, frame.colour.pixels.size());
    reader.read_colour(t.targets.colour(), frame.colour.pixels);

    const SceneNeeds needs = impl_->needs_of(config);
    frame.sampling = config.sampling;
    frame.hold_indirect(needs.indirect && key.indirect);
    for (int i = 0; i < pass_count; ++i) {
        const auto pass = static_cast<Pass>(i);
        const bool reflects = needs.reflections && key.bounces > 0;
        // What was not traced is left as it is.
        if (!frame.holds(pass) || (of_reflections(pass) && !reflects) || (shades(pass) && !key.shadows)) continue;
        const LayerTargets& from = t.targets.layer(pass);
        reader.read_hits(t.targets.hits(pass), frame.layer(pass).hit.pixels);
        if (key.counters && config.counters)
            reader.read_counters(from.counters_a.id(), from.counters_b.id(), frame.layer(pass).counters.pixels);
    }
    check_gl(t.gl, "reading the frame back");
    return frame;
}

}  // namespace kd
