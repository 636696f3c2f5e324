// The uniform blocks. C++ includes this file too (renderer/gl/blocks.h); vectors of four only, so that std140 and C++
// agree on every offset.

/// What an upload fixes. counts = triangles, lights, first texel of the lights and of the textures in kd_tables.
struct SceneBlock {
    real4 bounds_lower;
    real4 bounds_upper;
    real4 ambient;
    real4 background;
    int4 counts;
    int4 limits; // steps per ray, rounds of the loop check, the material where all triangles have one, number of nodes
};

/// What a draw fixes. image = width, height; rays = any_hit, number of rays, rays per row, and the
/// node that primary rays begin at.
struct FrameBlock {
    real4 eye;
    real4 right;
    real4 up;
    real4 forward;
    int4 image;
    int4 rays;
    real4 criteria; // x = least contribution of a reflection
    int4 entry;     // of tiles with entry points: the first pixel, pixels each way, tiles in a row
    int4 tile;      // the pixels drawn: first column and row, and those behind the last
    int4 wave;      // of rays with their state in buffers: slots, slots per pixel
    int4 sampling;  // number of the sample, seed
};
