// The whole tracer, written once. A host includes types.glsl, counters.glsl and constants.glsl, defines the hooks below,
// then includes this file: GLSL at file scope, C++ inside a class template (renderer/cpu/kernel.h).
//
// Data:     KdNode fetch_node(int node)                     int fetch_reference(int slot)
//           void fetch_node_box(int node, OUT lower, OUT upper)   void fetch_bounds(OUT lower, OUT upper)
//           void fetch_corners(int slot, int triangle, int3 axes, OUT a, OUT b, OUT c)   slot is -1 outside leaf lists
//           void fetch_normals(int triangle, OUT a, OUT b, OUT c)  void fetch_texture_coordinates(int triangle, OUT a, OUT b, OUT c)
//           int fetch_rope(int node, int face)              int entry_node()        int short_stack_entries()
//           int fetch_material_index(int triangle)          Material fetch_material(int)   Light fetch_light(int)
//           TextureImage fetch_texture(int)                 real4 fetch_texel(int)   bytes, 0..255
//           int triangle_count()   int light_count()        int step_budget()
// Settings: bool scene_has_normals()   bool scene_has_textures()   bool shadows_enabled()   bool scene_has_highlights()
//           bool scene_has_mip_maps()  bool scene_has_wraps()      bool scene_has_normal_maps()   bool scene_has_masks()
//           bool scene_has_emission()  bool scene_has_directional_lights()   bool scene_has_placed_lights()
//           bool scene_has_spot_lights()   bool scene_has_soft_shadows()   bool scene_has_gloss()   bool scene_has_indirect()
//           int sample_number()        uint sample_seed()
//           real3 scene_ambient()      real3 scene_background()
// Observer: void on_interior(int node, bool again)  on_leaf(int node)  on_triangle(int slot)  on_push(int depth)
//           on_restart()  on_backtrack()  on_exit(int reason)
// Macros:   KD_TRAVERSE (the walk to call), KD_TEST_LEAF (what walks call at a leaf: test_leaf, or what does the same),
//           KD_RULES (one of KD_RULES_...), KD_DEKKER, KD_FUSED, KD_CORRECTED_ROUNDING, KD_STACK_SIZE, KD_LONG_TRAIL,
//           KD_SHORT_STACK, KD_FN, KD_CALL_FN, KD_CONST, KD_RARE, PRECISE, IN, OUT, INOUT,
//           AXIS(vector, axis) (component by number), IS_NAN(x)

#include "vector.glsl"
#include "texture.glsl"
#include "ray.glsl"
#include "box.glsl"
#include "mask.glsl"
#include "triangle.glsl"
#include "split_rule.glsl"
#include "leaf.glsl"
#include "traversals.glsl"
#include "traverse.glsl"
#include "camera.glsl"
#include "surface.glsl"
#include "samples.glsl"
#include "path.glsl"
#include "lighting.glsl"
#include "scatter.glsl"
#include "passes.glsl"
