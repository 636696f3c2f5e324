// A small frame whose every number is known: a unit ball before the camera, counters that are formulas of x and y.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

#include "renderer/kdtree/tree.h"
#include "renderer/scene/camera.h"
#include "renderer/trace/frame.h"
#include "renderer/trace/judged_layer.h"
#include "renderer/trace/lockstep_layer.h"
#include "viz/text.h"

namespace kd::test {

inline constexpr int frame_width = 64, frame_height = 48;
/// Columns from here on are not traced.
inline constexpr int untraced_from = 60;

inline Camera ball_camera() {
    Camera camera;
    camera.eye = {0, 0, 3};
    camera.target = {0, 0, 0};
    camera.fov_y_degrees = 60;
    return camera;
}

inline glm::dvec3 pixel_direction(const PinholeCamera& camera, int x, int y, int width, int height) {
    const double u = (x + 0.5) * 2 / width - 1;
    const double v = 1 - (y + 0.5) * 2 / height;
    return glm::normalize(glm::dvec3(camera.forward) + u * glm::dvec3(camera.right) + v * glm::dvec3(camera.up));
}

/// Distance to the unit ball at the origin.
inline std::optional<double> distance_to_ball(glm::dvec3 origin, glm::dvec3 direction) {
    const double b = glm::dot(origin, direction);
    const double discriminant = b * b - (glm::dot(origin, origin) - 1);
    if (discriminant < 0) return std::nullopt;
    return -b - std::sqrt(discriminant);
}

inline RayCounters counters_at(int x, int y, bool hit) {
    RayCounters c{};
    c.interior_first = uint(5 + x / 4 + y / 8);
    c.interior_again = hit ? uint(x * y % 7) : 0;
    c.leaves = uint(1 + x % 5);
    c.triangle_tests = uint(y % 6);
    c.restarts = c.interior_again / 2;
    c.backtracks = c.interior_again / 3;
    c.stack_depth = uint(x / 8);
    c.exit_reason = uint(x == 2 && y < 5 ? y : hit ? KD_EXIT_HIT : KD_EXIT_MISS);
    return c;
}

inline Frame ball_frame(int width = frame_width, int height = frame_height) {
    Frame frame(width, height);
    const PinholeCamera camera = pinhole(ball_camera(), width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width && x < untraced_from; ++x) {
            const std::optional<double> t = distance_to_ball(camera.eye, pixel_direction(camera, x, y, width, height));
            const float shade = t ? float(3.2 - *t) : 0.2f;
            frame.colour.at(x, y) = {shade, 0.8f * shade, 0.5f, 1.0f};
            frame.layer(Pass::rt_prim).counters.at(x, y) = counters_at(x, y, t.has_value());
            if (!t) continue;
            frame.layer(Pass::rt_prim).hit.at(x, y) = {x + y, float(*t), 0.25f, 0.5f};
            frame.layer(Pass::shade_prim).counters.at(x, y).interior_first = uint(x);
            frame.layer(Pass::shade_prim).counters.at(x, y).leaves = 1;
        }
    }
    // The corner sees past the tree: traced, and nothing counted.
    frame.layer(Pass::rt_prim).counters.at(0, 0) = RayCounters{};
    return frame;
}

/// Verdicts on ball_frame()'s primary rays: columns of each, errors of t that grow from row to row.
inline JudgedLayer ball_judged(int width = frame_width, int height = frame_height) {
    JudgedLayer judged;
    judged.hits = Image<JudgedHit>(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width && x < untraced_from; ++x) {
            JudgedHit& hit = judged.hits.at(x, y);
            hit.verdict = HitVerdict(std::min(std::size_t(x / 8), verdict_count - 1));
            const bool both_hit = hit.verdict == HitVerdict::agrees || hit.verdict == HitVerdict::tie ||
                                  hit.verdict == HitVerdict::wrong_triangle || hit.verdict == HitVerdict::wrong_t;
            hit.ulps = both_hit ? y * 0.25 : std::numeric_limits<double>::infinity();
            hit.exact.triangle = hit.verdict == HitVerdict::false_hit ? -1 : 3;
            if (y < 6 && x < 8) hit = {HitVerdict::agrees, 0, {-1, 0.0, 0.0, 0.0}};  // past everything, rightly
        }
    judged.tally();
    return judged;
}

/// Groups of 8x4 of ball_frame()'s primary rays: numbers that are formulas of their place.
inline LockstepLayer ball_walks(Schedule schedule = Schedule::lockstep) {
    LockstepLayer walks(Pass::rt_prim, schedule, 8, 4, frame_width, frame_height);
    for (int y = 0; y < frame_height; ++y)
        for (int x = 0; x < frame_width && x < untraced_from; ++x) {
            walks.steps.at(x, y) = 10 + x % 8 + y;
            walks.overhead.at(x, y) = 1 + float(x * y % 50) / 25;
            walks.entry_depth.at(x, y) = float((x / 8 + y / 8) % 6);
            walks.steps_saved.at(x, y) = float(x % 8 + y % 8) - 2;
        }
    for (int y = 0; y < frame_height; y += 4)
        for (int x = 0; x < frame_width; x += 8) {
            const std::uint64_t column = std::uint64_t(x / 8), row = std::uint64_t(y / 4);
            LockstepGroup& group = walks.group_at(x, y);
            group.tally = {32 * (20 + row), 30 + 4 * row + 3 * column, 20};
            group.reads = {10, 10 * (8 + 2 * row), 10 * (1 + column) + row, 8 * (1 + column) + row, 7 * (1 + column)};
            group.rays = x < untraced_from ? 32 : 0;
            group.triangles = int(1 + column + row);
            group.leaves = int(1 + column);
        }
    walks.overhead.at(3, 40) = std::numeric_limits<float>::infinity();
    walks.unlike_hits = 1;
    walks.whole_overhead = 2.5;
    walks.entry = "8×8 px tiles";
    walks.share_saved = 0.25;
    return walks;
}

/// Box [-2,2]^3, split at x = 0, its upper half at y = 0.5: nodes 0 interior, 1 leaf, 2 interior, 3 and 4 leaves.
inline KdTree three_leaf_tree() {
    KdTree tree;
    tree.bounds = {Vec3(-2), Vec3(2)};
    tree.nodes.assign(5, TreeNode{});
    tree.nodes[0].flag = 0;
    tree.nodes[0].split = 0.0f;
    tree.nodes[0].link = 2;
    tree.nodes[1].parent = 0;
    tree.nodes[2].flag = 1;
    tree.nodes[2].split = 0.5f;
    tree.nodes[2].link = 4;
    tree.nodes[2].parent = 0;
    tree.nodes[3].parent = 2;
    tree.nodes[4].parent = 2;
    return tree;
}

/// DejaVu Sans where Debian installs it.
inline std::optional<Font> dejavu() {
    std::ifstream file("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", std::ios::binary);
    if (!file) return std::nullopt;
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return Font::from_bytes(std::as_bytes(std::span(bytes)));
}

}  // namespace kd::test
