// Embree (Wald, Woop, Benthin, Johnson and Ernst 2014) by single rays and by packets of 16, in default and robust
// scenes.

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "renderer/cpu/threads.h"
#include "renderer/peers/peers.h"

namespace kd {

namespace {

/// The triangles in a scene of Embree's, built with high quality on one thread of its own.
class EmbreeScene {
  public:
    EmbreeScene(const FlatScene& scene, RTCSceneFlags flags)
        // No "threads=1", which would hold TBB to one thread in all of the program; rays are answered by the caller's.
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
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
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    [[nodiscard]] RTCScene handle() const { return scene_; }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

RTCIntersectContext context_for(const PeerQuery& query) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = query.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

/// Of rtcOccluded: an occluded ray ends at minus infinity.
Hit occlusion(float tfar) { return {tfar < 0 ? 0 : -1, tfar, 0, 0}; }

void trace_singly(RTCScene scene, std::span<const Ray> rays, const PeerQuery& query, std::span<Hit> hits) {
    RTCIntersectContext context = context_for(query);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& r = rays[i];
        RTCRayHit asked{};
        asked.ray = {r.origin.x, r.origin.y, r.origin.z, r.t_min, r.direction.x, r.direction.y, r.direction.z, 0.0f,
                     r.t_max,    ~0u,        0,          0};
        if (query.any_hit) {
            rtcOccluded1(scene, &context, &asked.ray);
            hits[i] = occlusion(asked.ray.tfar);
            continue;
        }
        asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &asked);
        const bool found = asked.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        hits[i] = {found ? int(asked.hit.primID) : -1, asked.ray.tfar, asked.hit.u, asked.hit.v};
    }
}

constexpr std::size_t packet_width = 16;

/// The first of `rays`, transposed; lanes beyond their end are not valid.
void fill_packet(std::span<const Ray> rays, RTCRay16& packet, std::array<int, packet_width>& valid) {
    for (std::size_t lane = 0; lane < packet_width; ++lane) {
        valid[lane] = lane < rays.size() ? -1 : 0;
        const Ray& r = rays[std::min(lane, rays.size() - 1)];
        packet.org_x[lane] = r.origin.x;
        packet.org_y[lane] = r.origin.y;
        packet.org_z[lane] = r.origin.z;
        packet.tnear[lane] = r.t_min;
        packet.dir_x[lane] = r.direction.x;
        packet.dir_y[lane] = r.direction.y;
        packet.dir_z[lane] = r.direction.z;
        packet.time[lane] = 0;
        packet.tfar[lane] = r.t_max;
        packet.mask[lane] = ~0u;
        packet.id[lane] = 0;
        packet.flags[lane] = 0;
    }
}

void trace_packets(RTCScene scene, std::span<const Ray> rays, const PeerQuery& query, std::span<Hit> hits) {
    RTCIntersectContext context = context_for(query);
    alignas(64) std::array<int, packet_width> valid;
    alignas(64) RTCRayHit16 asked;
    for (std::size_t first = 0; first < rays.size(); first += packet_width) {
        const std::span<const Ray> some = rays.subspan(first, std::min(packet_width, rays.size() - first));
        fill_packet(some, asked.ray, valid);
        if (query.any_hit) {
            rtcOccluded16(valid.data(), scene, &context, &asked.ray);
            for (std::size_t i = 0; i < some.size(); ++i) hits[first + i] = occlusion(asked.ray.tfar[i]);
            continue;
        }
        std::ranges::fill(asked.hit.geomID, RTC_INVALID_GEOMETRY_ID);
        rtcIntersect16(valid.data(), scene, &context, &asked);
        for (std::size_t i = 0; i < some.size(); ++i) {
            const bool found = asked.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
            hits[first + i] = {found ? int(asked.hit.primID[i]) : -1, asked.ray.tfar[i], asked.hit.u[i],
                               asked.hit.v[i]};
        }
    }
}

class EmbreePeer final : public PeerTracer {
  public:
    EmbreePeer(std::string_view name, int width, std::shared_ptr<const EmbreeScene> scene, bool robust)
        : name_(name), width_(width), robust_(robust), scene_(std::move(scene)) {}

    [[nodiscard]] std::string_view name() const override { return name_; }
    [[nodiscard]] int width() const override { return width_; }
    [[nodiscard]] bool robust() const override { return robust_; }
    void trace(std::span<const Ray> rays, const PeerQuery& query, std::span<Hit> hits) const override {
        constexpr std::size_t rays_per_task = 1024;  // as CpuTracer has; whole packets
        const auto trace = width_ == 1 ? trace_singly : trace_packets;
        parallel_ranges(rays.size(), rays_per_task, query.threads, [&](std::size_t first, std::size_t last) {
            trace(scene_->handle(), rays.subspan(first, last - first), query, hits.subspan(first, last - first));
        });
    }

  private:
    std::string_view name_;
    int width_;
    bool robust_;
    std::shared_ptr<const EmbreeScene> scene_;
};

}  // namespace

std::string peers_version() { return fmt::format("Embree {}", RTC_VERSION_STRING); }

std::vector<std::unique_ptr<PeerTracer>> make_peers(const FlatScene& scene) {
    const auto standard = std::make_shared<const EmbreeScene>(scene, RTC_SCENE_FLAG_NONE);
    const auto robust = std::make_shared<const EmbreeScene>(scene, RTC_SCENE_FLAG_ROBUST);
    std::vector<std::unique_ptr<PeerTracer>> peers;
    peers.push_back(std::make_unique<EmbreePeer>("embree-1-robust", 1, robust, true));
    peers.push_back(std::make_unique<EmbreePeer>("embree-1", 1, standard, false));
    peers.push_back(std::make_unique<EmbreePeer>("embree-16-robust", int(packet_width), robust, true));
    peers.push_back(std::make_unique<EmbreePeer>("embree-16", int(packet_width), standard, false));
    return peers;
}

}  // namespace kd
