// The difference that a person sees when two images are shown in turn: FLIP for displayed colours.
//
// Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem, Fairchild: "FLIP: A Difference Evaluator for Alternating
// Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020.
#pragma once

#include <array>
#include <vector>

#include "renderer/geometry/image.h"
#include "renderer/geometry/shared_types.h"

namespace kd {

/// A display 0.7 m wide with 3840 pixels, seen from 0.7 m: the paper's.
inline constexpr double flip_pixels_per_degree = 67.0206;

/// Images seen against one reference, whose share of the work is done once. Colours are sRGB as displayed; what lies
/// outside 0..1 is clipped.
class Flip {
  public:
    explicit Flip(const Image<glm::dvec3>& reference, double pixels_per_degree = flip_pixels_per_degree);

    /// 0 (alike) to 1 at every pixel. The image must be as large as the reference.
    [[nodiscard]] Image<double> map(const Image<glm::dvec3>& image) const;
    /// Its mean.
    [[nodiscard]] double mean(const Image<glm::dvec3>& image) const;

    using Plane = std::vector<double>;
    /// One image as FLIP sees it.
    struct Seen {
        std::array<Plane, 3> lab;       // filtered by the eye, with Hunt's adjustment
        std::array<Plane, 2> features;  // strengths of edges and of points
    };

  private:
    double pixels_per_degree_;
    int width_, height_;
    Seen reference_;
};

}  // namespace kd
