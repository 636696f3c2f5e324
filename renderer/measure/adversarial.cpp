// Rays chosen to break traversals: every family below has lost hits in some published or shipped tracer.

#include <array>
#include <cmath>
#include <limits>

#include "renderer/measure/path_rays.h"
#include "renderer/measure/verify.h"
#include "renderer/scene/random.h"

namespace kd {

namespace {

class RayMaker {
  public:
    RayMaker(const FlatScene& scene, const KdTree& tree, unsigned seed)
        : scene_(scene), triangles_(scene.triangles), tree_(tree), boxes_(node_boxes(tree)), random_(seed) {
        bounds_ = tree.bounds.empty() ? Aabb{Vec3(-1), Vec3(1)} : tree.bounds;
        const Vec3 extent = bounds_.extent();
        size_ = std::max({extent.x, extent.y, extent.z, std::numeric_limits<float>::min()});
        for (std::size_t node = 0; node < tree.nodes.size(); ++node)
            if (!tree.nodes[node].is_leaf()) interior_.push_back(node);
    }

    Ray make(std::size_t number) { return (this->*families[number % families.size()])(); }

  private:
    static Ray ray(Vec3 origin, Vec3 direction) { return {origin, direction, 0.0f, KD_T_LIMIT, -1}; }

    float between(float low, float high) { return float(random_.between(low, high)); }
    std::size_t below(std::size_t n) { return std::size_t(random_.next() % n); }
    bool coin() { return (random_.next() >> 63) != 0; }
    /// Never short.
    Vec3 any_direction() {
        while (true) {
            const Vec3 d(between(-1, 1), between(-1, 1), between(-1, 1));
            if (d.x * d.x + d.y * d.y + d.z * d.z > 0.01f) return d;
        }
    }

    float signed_zero() { return coin() ? 0.0f : -0.0f; }
    float sign() { return coin() ? 1.0f : -1.0f; }
    int axis() { return int(below(3)); }

    Vec3 axis_direction(int along) {
        Vec3 d(signed_zero(), signed_zero(), signed_zero());
        d[along] = sign();
        return d;
    }

    Vec3 point_in(const Aabb& box, float reach = 1.0f) {
        const Vec3 half = 0.5f * reach * box.extent();
        const Vec3 r(between(-1, 1), between(-1, 1), between(-1, 1));
        return box.centre() + half * r;
    }

    std::size_t any_triangle() { return below(triangles_.size()); }
    Vec3 vertex() {
        if (triangles_.empty()) return point_in(bounds_);
        return triangles_[any_triangle()].corner[below(3)];
    }
    /// Inside the box of the scene, or some way outside.
    Vec3 origin() { return point_in(bounds_, coin() ? 0.9f : 4.0f); }

    Ray at_vertex() {
        const Vec3 o = origin();
        return ray(o, vertex() - o);
    }

    Ray at_edge() {
        const Vec3 o = origin();
        if (triangles_.empty()) return ray(o, any_direction());
        const Triangle& t = triangles_[any_triangle()];
        const std::size_t i = below(3);
        return ray(o, glm::mix(t.corner[i], t.corner[(i + 1) % 3], between(0, 1)) - o);
    }

    /// Through a vertex exactly, or anywhere.
    Ray along_axis() {
        const int along = axis();
        Vec3 o = coin() ? vertex() : point_in(bounds_);
        const Vec3 d = axis_direction(along);
        o[along] = coin() ? o[along] : bounds_.centre()[along] - d[along] * 2.0f * size_;
        return ray(o, d);
    }

    /// Three split planes at one t where the geometry lies on a lattice.
    Ray along_diagonal() {
        const Vec3 d(sign(), sign(), sign());
        return ray(vertex() - d * (coin() ? size_ : 0.5f * size_), d);
    }

    /// On a split plane, within the node's cell or a little outside of it.
    Vec3 on_split_plane(int& along) {
        if (interior_.empty()) {
            along = axis();
            return point_in(bounds_);
        }
        const std::size_t node = interior_[below(interior_.size())];
        along = tree_.nodes[node].flag;
        Vec3 o = point_in(boxes_[node], 1.5f);
        o[along] = tree_.nodes[node].split;
        return o;
    }

    Ray inside_split_plane() {
        int along = 0;
        const Vec3 o = on_split_plane(along);
        Vec3 d = coin() ? any_direction() : axis_direction((along + 1 + int(below(2))) % 3);
        d[along] = signed_zero();
        return ray(o, d);
    }

    Ray from_split_plane() {
        int along = 0;
        const Vec3 o = on_split_plane(along);
        return ray(o, coin() ? any_direction() : axis_direction(along));
    }

    /// Along an edge of a cell, in one of its faces, or from one of its corners.
    Ray grazing_box() {
        const Aabb& box = coin() ? bounds_ : boxes_[below(boxes_.size())];
        Vec3 corner;
        for (int i = 0; i < 3; ++i) corner[i] = coin() ? box.lower[i] : box.upper[i];
        const int along = axis();
        Vec3 d = axis_direction(along);
        switch (below(3)) {
            case 0: corner[along] -= d[along] * size_ * between(0.0f, 2.0f); break;
            case 1: d[(along + 1) % 3] = between(-1, 1); break;
            default: d = any_direction(); break;
        }
        return ray(corner, d);
    }

    Ray from_afar() {
        Vec3 d = any_direction();
        const float distance = size_ * std::pow(10.0f, between(3.0f, 5.0f));
        const Vec3 target = coin() ? vertex() : point_in(bounds_);
        if (below(4) == 0) d = axis_direction(axis());
        return ray(target - d * distance, d);
    }

    /// Somewhere in a triangle.
    Vec3 point_in(const Triangle& t) {
        float u = between(0, 1);
        float v = between(0, 1);
        if (u + v > 1.0f) {
            u = 1.0f - u;
            v = 1.0f - v;
        }
        return t.corner[0] * (1.0f - u - v) + t.corner[1] * u + t.corner[2] * v;
    }

    /// As shadow and mirror rays start, by the tracers' own text: from where a ray hits a triangle.
    Ray from_surface() {
        if (triangles_.empty()) return ray(origin(), any_direction());
        const std::size_t number = any_triangle();
        const Vec3 o = origin();
        const Ray arriving = ray(o, point_in(triangles_[number]) - o);
        const Hit hit = hit_of_triangle(scene_, int(number), arriving);
        if (hit.triangle < 0) return arriving;
        Ray leaving = leave_hit(scene_, arriving, hit, any_direction()).ray;
        if (coin()) leaving.source = -1;
        return leaving;
    }

    /// Unit normal of a triangle; a random direction of one without area.
    Vec3 normal_of(const Triangle& t) {
        const auto& [a, b, c] = t.corner;
        const Vec3 n = glm::cross(b - a, c - a);
        const float length = glm::length(n);
        return length > 0.0f ? n / length : glm::normalize(any_direction());
    }

    /// Meets a triangle at 1e-3 to 1e-7 radians.
    Ray grazing_triangle() {
        if (triangles_.empty()) return ray(origin(), any_direction());
        const Triangle& t = triangles_[any_triangle()];
        const Vec3 p = point_in(t), along = point_in(t) - p;
        const float length = glm::length(along);
        if (!(length > 0.0f)) return ray(origin(), any_direction());
        const float angle = std::pow(10.0f, between(-7.0f, -3.0f));
        const Vec3 d = along / length - normal_of(t) * (sign() * angle);
        return ray(p - d * (size_ * between(0.01f, 1.0f)), d);
    }

    /// Begins 1e-3 to 1e-7 scene sizes off a triangle.
    Ray beside_triangle() {
        if (triangles_.empty()) return ray(origin(), any_direction());
        const Triangle& t = triangles_[any_triangle()];
        const float away = size_ * std::pow(10.0f, between(-7.0f, -3.0f));
        return ray(point_in(t) + normal_of(t) * (sign() * away), any_direction());
    }

    Ray inside_triangle_plane() {
        if (triangles_.empty()) return ray(origin(), any_direction());
        const auto& [a, b, c] = triangles_[any_triangle()].corner;
        const auto in_plane = [&](float reach) {
            return a + (b - a) * between(-reach, reach) + (c - a) * between(-reach, reach);
        };
        const Vec3 o = in_plane(3.0f);
        const Vec3 d = in_plane(1.0f) - o;
        return ray(o, d);
    }

    Ray of_odd_length() {
        constexpr std::array lengths{1e-20f, 1e-3f, 1e3f, 1e15f};
        const Vec3 o = origin();
        const Vec3 d = coin() ? vertex() - o : any_direction();
        const float largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        return ray(o, largest > 0.0f ? d / largest * lengths[below(lengths.size())] : d);
    }

    /// The vertex aimed at lies at t = 1: just inside, at, or outside of the interval.
    Ray with_interval() {
        Ray r = at_vertex();
        constexpr std::array ends{0x1.fffffep-1f, 1.0f, 0x1.000002p+0f};
        if (coin())
            r.t_max = ends[below(ends.size())];
        else
            r.t_min = ends[below(ends.size())];
        return r;
    }

    Ray invalid() {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        constexpr float infinity = std::numeric_limits<float>::infinity();
        Ray r = at_vertex();
        switch (below(5)) {
            case 0: r.direction = Vec3(signed_zero(), signed_zero(), signed_zero()); break;
            case 1: r.direction[axis()] = coin() ? nan : infinity; break;
            case 2: r.origin[axis()] = coin() ? nan : -infinity; break;
            case 3: r.t_min = nan; break;
            default: r.t_max = 0.0f; break;
        }
        return r;
    }

    using Family = Ray (RayMaker::*)();
    static constexpr std::array<Family, 15> families{
        &RayMaker::at_vertex,
        &RayMaker::at_edge,
        &RayMaker::along_axis,
        &RayMaker::along_diagonal,
        &RayMaker::inside_split_plane,
        &RayMaker::from_split_plane,
        &RayMaker::grazing_box,
        &RayMaker::from_afar,
        &RayMaker::from_surface,
        &RayMaker::grazing_triangle,
        &RayMaker::beside_triangle,
        &RayMaker::inside_triangle_plane,
        &RayMaker::of_odd_length,
        &RayMaker::with_interval,
        &RayMaker::invalid,
    };

    const FlatScene& scene_;
    const std::vector<Triangle>& triangles_;
    const KdTree& tree_;
    std::vector<Aabb> boxes_;
    std::vector<std::size_t> interior_;
    Aabb bounds_;
    float size_ = 1.0f;
    Random random_;
};

}  // namespace

std::vector<Ray> adversarial_rays(const FlatScene& scene, const KdTree& tree, int count, unsigned seed) {
    RayMaker maker(scene, tree, seed);
    std::vector<Ray> rays;
    rays.reserve(std::size_t(std::max(count, 0)));
    for (int i = 0; i < count; ++i) rays.push_back(maker.make(std::size_t(i)));
    return rays;
}

}  // namespace kd
