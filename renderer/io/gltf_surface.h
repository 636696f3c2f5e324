// Physically based surfaces as the Phong-type materials of this renderer.
#pragma once

#include <glm/vec3.hpp>

#include "renderer/geometry/shared_types.h"

namespace kd {

/// A surface as glTF describes it. Colours are linear, 0..1.
struct PbrSurface {
    glm::dvec3 base{1.0};     // what is scattered
    glm::dvec3 facing{0.04};  // mirrored fraction at perpendicular view (F0)
    double metal = 0.0;       // 0 dielectric .. 1 metal
    double roughness = 1.0;   // 0..1
};

/// glTF 2.0, section 3.9.2 and appendix B: F0 goes from 0.04 to the base colour with `metallic`.
[[nodiscard]] PbrSurface metallic_roughness(glm::dvec3 base, double metallic, double roughness);

/// KHR_materials_pbrSpecularGlossiness: F0 is given; the larger it is, the more of a metal the surface is.
[[nodiscard]] PbrSurface specular_glossiness(glm::dvec3 diffuse, glm::dvec3 specular, double glossiness);

/// The renderer adds display-referred colours, so linear ones are encoded (sRGB). With smoothness = 1 - roughness:
///   diffuse     = encoded(base * (1 - metal * smoothness)): a rough metal is shown as if it scattered, not black
///   specular    = encoded(F0) * smoothness
///   shininess   = 2 / alpha^2 - 2 with alpha = roughness^2, kept within 2..1024: the Blinn-Phong exponent of a
///   highlight
///                 of that roughness (Karis, "Specular BRDF Reference", 2013)
///   reflectance = blend of F0 (dielectric) and encoded(F0) (metal), times smoothness^2; 0 from roughness 0.5 on, and
///                 per channel below 1/255, so that ordinary dielectrics call for no reflection passes. F0 of a
///                 dielectric stays linear, as its reflection is added to a scattered colour, where the encoding is
///                 about straight.
[[nodiscard]] Material to_material(const PbrSurface& surface, int texture);

/// Linear 0..1 to sRGB-encoded 0..1 (IEC 61966-2-1), each channel by itself, and back.
[[nodiscard]] glm::dvec3 srgb_encoded(glm::dvec3 linear);
[[nodiscard]] glm::dvec3 srgb_decoded(glm::dvec3 encoded);

}  // namespace kd
