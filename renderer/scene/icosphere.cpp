#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "renderer/scene/sphere_shapes.h"

namespace kd {

namespace {

using Corners = std::array<glm::dvec3, 12>;
using Face = std::array<std::uint32_t, 3>;

/// (0, ±1, ±phi) and its cyclic shifts; edges have length 2.
Corners icosahedron_corners() {
    Corners corners{};
    std::size_t next = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double one : {-1.0, 1.0}) {
            for (const double phi : {-std::numbers::phi, std::numbers::phi}) {
                glm::dvec3& corner = corners[next++];
                corner[(axis + 1) % 3] = one;
                corner[(axis + 2) % 3] = phi;
            }
        }
    }
    return corners;
}

/// All triples of corners that are neighbours of each other, counter-clockwise seen from outside.
std::vector<Face> icosahedron_faces(const Corners& corners) {
    const auto adjacent = [&](std::uint32_t a, std::uint32_t b) { return glm::distance(corners[a], corners[b]) < 2.1; };
    std::vector<Face> faces;
    for (std::uint32_t a = 0; a < 12; ++a) {
        for (std::uint32_t b = a + 1; b < 12; ++b) {
            for (std::uint32_t c = b + 1; c < 12; ++c) {
                if (!adjacent(a, b) || !adjacent(b, c) || !adjacent(c, a)) continue;
                const bool outward = glm::dot(glm::cross(corners[a], corners[b]), corners[c]) > 0.0;
                faces.push_back(outward ? Face{a, b, c} : Face{a, c, b});
            }
        }
    }
    return faces;
}

/// Numbers of the points of a face's lattice, where faces share those on common corners and edges. A lattice point has
/// whole weights for the face's three corners that add up to the frequency.
class Lattice {
  public:
    explicit Lattice(int frequency) : n_(std::uint32_t(frequency)) {
        for (auto& row : edges_) row.fill(none);
    }

    [[nodiscard]] std::size_t size() const { return std::size_t(10) * n_ * n_ + 2; }

    std::uint32_t number(std::uint32_t face_number, const Face& face, const std::array<std::uint32_t, 3>& weight) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (weight[i] == n_) return face[i];
        }
        for (std::size_t i = 0; i < 3; ++i) {
            if (weight[i] == 0) return on_edge(face[(i + 1) % 3], face[(i + 2) % 3], weight[(i + 2) % 3]);
        }
        const std::uint32_t row = weight[0] - 1;  // holds n - 2 - row points
        const std::uint32_t before = row * (n_ - 2) - row * (row - 1) / 2;
        return 12 + 30 * (n_ - 1) + face_number * ((n_ - 1) * (n_ - 2) / 2) + before + weight[1] - 1;
    }

  private:
    static constexpr std::uint32_t none = ~0u;

    /// The point with weight `weight_b` for b and the rest for a.
    std::uint32_t on_edge(std::uint32_t a, std::uint32_t b, std::uint32_t weight_b) {
        if (a > b) return on_edge(b, a, n_ - weight_b);
        if (edges_[a][b] == none) edges_[a][b] = edge_count_++;
        return 12 + edges_[a][b] * (n_ - 1) + weight_b - 1;
    }

    std::uint32_t n_;
    std::uint32_t edge_count_ = 0;
    std::array<std::array<std::uint32_t, 12>, 12> edges_;
};

}  // namespace

int icosphere_frequency(int wanted) {
    const int below = std::max(1, int(std::sqrt(double(std::max(wanted, 0)) / 20.0)));
    const int above = below + 1;
    return 20 * above * above - wanted < wanted - 20 * below * below ? above : below;
}

void add_icosphere(Mesh& mesh, Vec3 centre, double radius, int frequency) {
    const auto first = std::uint32_t(mesh.positions.size());
    const auto n = std::uint32_t(frequency);
    const Corners corners = icosahedron_corners();
    const std::vector<Face> faces = icosahedron_faces(corners);
    Lattice lattice(frequency);
    mesh.positions.resize(first + lattice.size());
    mesh.normals.resize(first + lattice.size());

    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const Face& face = faces[f];
        const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
            const std::uint32_t number = first + lattice.number(f, face, {i, j, n - i - j});
            const glm::dvec3 direction = glm::normalize(double(i) * corners[face[0]] + double(j) * corners[face[1]] +
                                                        double(n - i - j) * corners[face[2]]);
            mesh.positions[number] = Vec3(glm::dvec3(centre) + radius * direction);
            mesh.normals[number] = Vec3(direction);
            return number;
        };
        for (std::uint32_t i = 0; i < n; ++i) {
            for (std::uint32_t j = 0; i + j < n; ++j) {
                mesh.indices.insert(mesh.indices.end(), {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
                if (i + j + 1 < n)
                    mesh.indices.insert(mesh.indices.end(), {vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
            }
        }
    }
}

}  // namespace kd
