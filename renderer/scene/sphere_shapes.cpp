#include "renderer/scene/sphere_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace kd {

namespace {

void add_sphere_point(Mesh& mesh, Vec3 centre, double radius, glm::dvec3 direction) {
    mesh.positions.emplace_back(glm::dvec3(centre) + radius * direction);
    mesh.normals.emplace_back(direction);
}

}  // namespace

UvTessellation uv_tessellation(int wanted) {
    UvTessellation best;
    const auto worse_than = [wanted](const UvTessellation& a, const UvTessellation& b) {
        const auto rank = [wanted](const UvTessellation& t) {
            return std::pair(std::abs(t.triangles() - wanted), std::abs(t.segments - 2 * t.rings));
        };
        return rank(a) > rank(b);
    };
    const int most_rings = int(std::sqrt(double(std::max(wanted, 0)) / 3.0)) + 3;
    for (int rings = 2; rings <= most_rings; ++rings) {
        const int around = int(std::lround(double(wanted) / (2.0 * (rings - 1))));
        const UvTessellation candidate{std::clamp(around, (3 * rings + 1) / 2, 5 * rings / 2), rings};
        if (worse_than(best, candidate)) best = candidate;
    }
    return best;
}

void add_uv_sphere(Mesh& mesh, Vec3 centre, double radius, UvTessellation tessellation) {
    const auto first = std::uint32_t(mesh.positions.size());
    const auto segments = std::uint32_t(tessellation.segments);
    const auto parallels = std::uint32_t(tessellation.rings - 1);

    add_sphere_point(mesh, centre, radius, {0.0, 1.0, 0.0});
    for (std::uint32_t ring = 1; ring <= parallels; ++ring) {
        const double polar = std::numbers::pi * ring / tessellation.rings;
        for (std::uint32_t segment = 0; segment < segments; ++segment) {
            const double azimuth = 2.0 * std::numbers::pi * segment / tessellation.segments;
            add_sphere_point(
                mesh, centre, radius,
                {std::sin(polar) * std::sin(azimuth), std::cos(polar), std::sin(polar) * std::cos(azimuth)});
        }
    }
    add_sphere_point(mesh, centre, radius, {0.0, -1.0, 0.0});

    const std::uint32_t last = first + 1 + parallels * segments;
    const auto point = [=](std::uint32_t ring, std::uint32_t segment) {
        return first + 1 + ring * segments + segment % segments;
    };
    for (std::uint32_t s = 0; s < segments; ++s) {
        mesh.indices.insert(mesh.indices.end(), {first, point(0, s), point(0, s + 1)});
        for (std::uint32_t r = 0; r + 1 < parallels; ++r) {
            const std::uint32_t a = point(r, s), b = point(r + 1, s), c = point(r + 1, s + 1), d = point(r, s + 1);
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
        mesh.indices.insert(mesh.indices.end(), {last, point(parallels - 1, s + 1), point(parallels - 1, s)});
    }
}

}  // namespace kd
