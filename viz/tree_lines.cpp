#include "viz/tree_lines.h"

#include <array>

#include "renderer/kdtree/hand_split.h"
#include "viz/projection.h"

namespace kd {

void add_plane(const TreeNode& n, const Cell& cell, std::vector<WorldLine>& lines) {
    const int u = (n.flag + 1) % 3;
    const int v = (n.flag + 2) % 3;
    std::array<Vec3, 4> corner;
    for (std::size_t i = 0; i < 4; ++i) {
        corner[i][n.flag] = n.split;
        corner[i][u] = i == 1 || i == 2 ? cell.box.upper[u] : cell.box.lower[u];
        corner[i][v] = i >= 2 ? cell.box.upper[v] : cell.box.lower[v];
    }
    for (std::size_t i = 0; i < 4; ++i) lines.push_back({corner[i], corner[(i + 1) % 4], cell.depth, cell.node});
}

void add_box(const Cell& cell, std::vector<WorldLine>& lines) {
    const auto corner = [&](unsigned i) {
        return Vec3((i & 1) != 0 ? cell.box.upper.x : cell.box.lower.x,
                    (i & 2) != 0 ? cell.box.upper.y : cell.box.lower.y,
                    (i & 4) != 0 ? cell.box.upper.z : cell.box.lower.z);
    };
    for (unsigned i = 0; i < 8; ++i) {
        for (unsigned bit = 1; bit < 8; bit <<= 1) {
            if ((i & bit) == 0) lines.push_back({corner(i), corner(i | bit), cell.depth, cell.node});
        }
    }
}

std::vector<ScreenLine> on_screen(const std::vector<WorldLine>& lines, const PinholeCamera& camera, int width,
                                  int height, std::size_t most) {
    const Projection projection(camera, width, height);
    std::vector<ScreenLine> seen;
    for (const WorldLine& line : lines) {
        if (seen.size() >= most) break;
        if (const auto s = projection.project_segment(line.a, line.b))
            seen.push_back({float(s->a.x), float(s->a.y), float(s->b.x), float(s->b.y), line.depth});
    }
    return seen;
}

}  // namespace kd
