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
    const bool reflects = needs.reflections && key.bounces > 0;
    for (const Pass pass : {Pass::rt_prim, Pass::shade_prim, Pass::rt_refl, Pass::shade_refl}) {
        const bool reflected = pass == Pass::rt_refl || pass == Pass::shade_refl;
        const bool shades = pass == Pass::shade_prim || pass == Pass::shade_refl;
        if ((reflected && !reflects) || (shades && !key.shadows)) continue;  // left as nothing was traced
        const LayerTargets& from = t.targets.layer(pass);
        const GLuint hit = pass == Pass::rt_refl ? t.targets.first_reflection_hit() : from.hit.id();
        reader.read_hits(hit, frame.layer(pass).hit.pixels);
        if (key.counters && config.counters)
            reader.read_counters(from.counters_a.id(), from.counters_b.id(), frame.layer(pass).counters.pixels);
    }
    check_gl(t.gl, "reading the frame back");
    return frame;
}

}  // namespace kd
