// Embree as a peer: single rays through one static scene.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <span>

#include "renderer/scene/scene.h"

namespace kd {

/// One Embree scene; `trace` answers the rays one by one, conversion of rays and hits included.
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

}  // namespace kd
