// The values that travel between the parts of the tracer, on both machines.
//
// `real` is float in GLSL and in the CPU tracers and double in the oracle; real2, real3 and real4 are its vectors.

/// A ray o + t*d with t in the open interval (t_min, t_max). `source` is the triangle it starts on, or -1.
struct Ray {
    real3 origin;
    real3 direction;
    real t_min;
    real t_max;
    int source;
};

/// Nearest intersection: point = (1-u-v)*v0 + u*v1 + v*v2 of `triangle`, -1 where nothing was hit (t is then the ray's t_max).
struct Hit {
    int triangle;
    real t;
    real u;
    real v;
};

/// One node of the tree. Interior: flag = split axis 0..2, `split` = plane position, `link` = child above (child below
/// is at this node + 1). Leaf: flag = KD_LEAF, `count` = number of references, `link` = first reference.
/// `parent` is -1 at the root. Layout: "An Analysis of GPU-based Interactive Raytracing", section 2.3.1.
struct KdNode {
    int flag;
    real split;
    int count;
    int link;
    int parent;
};

/// Pinhole camera; `right` and `up` reach from the image centre to its edges at distance |forward|.
struct PinholeCamera {
    real3 eye;
    real3 right;
    real3 up;
    real3 forward;
};

/// Phong-type surface in display-referred colour, 0..1 per channel; `emission`, what it sends by itself, may be brighter.
/// `texture` tints what it scatters, `emission_texture` what it emits; -1 for none. `roughness`, 0..1, is that of what it
/// reflects: 0 mirrors; squared it is the alpha of Trowbridge & Reitz's distribution of facets, as glTF has it.
/// `normal_texture` holds normals in the triangle's tangent space (glTF 2.0, section 3.9.3), whose x and y `normal_scale`
/// stretches. Where the alpha of `texture` is below `alpha_cutoff` there is no surface; 0 cuts nothing out.
struct Material {
    real3 diffuse;
    real3 specular;
    real3 reflectance;
    real3 emission;
    real shininess;
    int texture;
    int emission_texture;
    real roughness;
    int normal_texture;
    real normal_scale;
    real alpha_cutoff;
};

/// One of the scene's images: its first texel among those of all, its size, how many levels there are from it on, each half
/// the one before it and right behind it, and how it goes on beyond its edges (KD_WRAP_...).
struct TextureImage {
    int first;
    int width;
    int height;
    int levels;
    int wrap_x;
    int wrap_y;
};

/// A light; intensity falls with 1 / (attenuation.x + attenuation.y * distance^2). Spot cosines are of half angles. Sampled,
/// it is a disc of `radius` that faces the point lit; of a directional light that is the tangent of its half angle.
struct Light {
    int kind;
    real3 position;
    real3 direction;
    real3 colour;
    real2 attenuation;
    real range;
    real cos_inner;
    real cos_outer;
    real radius;
};
