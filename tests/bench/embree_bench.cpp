// kdscope's traversals against Embree's rtcIntersect1 on the same primary rays, one thread, in turn, in one run.
//
// usage: embree_bench [SCENE] [ROUNDS]      default ball:9000, 15 rounds

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/cpu/cpu_tracer.h"
#include "renderer/kdtree/build.h"
#include "renderer/measure/timing.h"
#include "renderer/scene/procedural.h"

namespace {

using namespace kd;

constexpr int image_size = 512;

/// Spreads the low 9 bits of x over the even bits.
unsigned spread(unsigned x) {
    unsigned out = 0;
    for (unsigned bit = 0; bit < 9; ++bit) out |= (x >> bit & 1u) << (2 * bit);
    return out;
}

/// The camera's rays along a Morton curve, the order that both tracers get.
std::vector<Ray> primary_rays(const FlatScene& scene) {
    const PinholeCamera camera = pinhole(scene.camera, image_size, image_size);
    std::vector<Ray> rays(std::size_t(image_size) * image_size);
    for (unsigned y = 0; y < image_size; ++y)
        for (unsigned x = 0; x < image_size; ++x) {
            const float across = (float(x) + 0.5f) * 2.0f / float(image_size) - 1.0f;
            const float down = 1.0f - (float(y) + 0.5f) * 2.0f / float(image_size);
            const Vec3 d = camera.forward + camera.right * across + camera.up * down;
            rays[spread(x) | spread(y) << 1u] = {camera.eye, d, 0.0f, KD_T_LIMIT, -1};
        }
    return rays;
}

/// One Embree scene; `run` traces the rays once, conversion included, and counts the hits.
class EmbreeTracer {
  public:
    EmbreeTracer(const FlatScene& scene, RTCSceneFlags flags)
        : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, flags);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::size_t n = scene.triangles.size();
        auto* corners = static_cast<float*>(
            rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * n));
        auto* indices = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), n));
        for (std::size_t i = 0; i < 3 * n; ++i) {
            const Vec3 p = scene.triangles[i / 3].corner[i % 3];
            std::copy_n(&p.x, 3, corners + 3 * i);
            indices[i] = unsigned(i);
        }
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene_, mesh);
        rtcReleaseGeometry(mesh);
        rtcCommitScene(scene_);
    }
    ~EmbreeTracer() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeTracer(const EmbreeTracer&) = delete;
    EmbreeTracer& operator=(const EmbreeTracer&) = delete;

    void trace(std::span<const Ray> rays, std::span<Hit> hits) const {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
            const Ray& ray = rays[i];
            RTCRayHit query{};
            query.ray = {ray.origin.x,
                         ray.origin.y,
                         ray.origin.z,
                         ray.t_min,
                         ray.direction.x,
                         ray.direction.y,
                         ray.direction.z,
                         0.0f,
                         ray.t_max,
                         ~0u,
                         0,
                         0};
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &query);
            const bool found = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            hits[i] = {found ? int(query.hit.primID) : -1, query.ray.tfar, query.hit.u, query.hit.v};
        }
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

std::size_t count_hits(const std::vector<Hit>& hits) {
    return std::size_t(std::ranges::count_if(hits, [](const Hit& h) { return h.triangle >= 0; }));
}

int run(const std::string& name, int rounds) {
    const std::optional<Scene> made = make_procedural(name);
    if (!made) throw InputError(name + ": no such procedural scene");
    const FlatScene scene = flatten(*made);
    const BuildConfig build;
    const KdTree tree = build_tree(scene.triangles, build);
    const std::vector<Ray> rays = primary_rays(scene);
    CpuTracer tracer(scene, tree);
    const EmbreeTracer robust(scene, RTC_SCENE_FLAG_ROBUST), standard(scene, RTC_SCENE_FLAG_NONE);

    std::vector<std::vector<Hit>> hits;
    std::vector<Contestant> contestants;
    const auto compete = [&](std::string label, auto trace) {
        const std::size_t slot = hits.size();
        hits.emplace_back(rays.size());
        contestants.push_back({std::move(label), [&hits, slot, trace] { return wall_ms([&] { trace(hits[slot]); }); }});
    };
    compete("embree robust", [&](std::vector<Hit>& out) { robust.trace(rays, out); });
    compete("embree default", [&](std::vector<Hit>& out) { standard.trace(rays, out); });
    for (const TraversalInfo& t : traversals()) {
        if (t.id == Traversal::naive) continue;
        for (const LeafLists lists : {LeafLists::references, LeafLists::duplicated})
            compete("kdscope " + std::string(t.name) + (lists == LeafLists::duplicated ? ", copies" : ""),
                    [&, id = t.id, lists](std::vector<Hit>& out) {
                        TraceConfig config;
                        config.traversal = id;
                        config.leaf_lists = lists;
                        tracer.trace_rays(config, rays, false, out, {}, 1);
                    });
    }
    const std::vector<TimeSummary> times = time_interleaved(contestants, 2, rounds);

    std::printf("%s, %zu triangles, %dx%d primary rays in Morton order, 1 thread, %s, %d rounds in turn\n",
                name.c_str(), scene.triangles.size(), image_size, image_size, cpu_target_name().c_str(), rounds);
    std::printf("builder %s: t_t %g, t_i %g, empty bonus %g (gate %g), leaf size %d, depth %d, bad refines %d, leaves "
                "trimmed to %s\n",
                build.builder.c_str(), double(build.traversal_cost), double(build.intersection_cost),
                double(build.empty_bonus), double(build.empty_bonus_gate), build.leaf_size,
                depth_limit(build, scene.triangles.size()), build.bad_refines,
                build.trim_leaves ? "surfaces" : "boxes");
    std::printf("%-24s %9s %19s %9s %12s %12s %9s\n", "tracer", "ms", "[p25 - p75]", "Mrays/s", "x robust", "x default",
                "hits");
    for (std::size_t i = 0; i < contestants.size(); ++i) {
        const TimeSummary& t = times[i];
        std::printf("%-24s %9.2f [%7.2f - %7.2f] %9.2f %12.3f %12.3f %9zu\n", contestants[i].name.c_str(), t.median_ms,
                    t.p25_ms, t.p75_ms, double(rays.size()) / t.median_ms / 1e3, times[0].median_ms / t.median_ms,
                    times[1].median_ms / t.median_ms, count_hits(hits[i]));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc > 1 ? argv[1] : "ball:9000", argc > 2 ? std::stoi(argv[2]) : 15);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "embree_bench: %s\n", error.what());
        return 2;
    }
}
