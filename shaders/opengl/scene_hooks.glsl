// The data and settings hooks of shaders/shared/kernel.glsl.

#if KD_PACKED_NODES
/// As node_as_read() in renderer/kdtree/encode.h.
KdNode fetch_node(int node)
{
    uvec2 texel = node_words(node);
    KdNode n;
    n.flag = int(texel.y & 3u);
    n.split = uintBitsToFloat(texel.x);
    n.count = int(texel.x);
    n.link = int(texel.y >> 2u);
    n.parent = -1;
    return n;
}
#else
KdNode fetch_node(int node)
{
    vec4 texel = node_texel(node);
    KdNode n;
    n.flag = int(texel.x);
    n.split = texel.y;
    n.count = n.flag == KD_LEAF ? int(texel.y) : 0;
    n.link = int(texel.z);
    n.parent = int(texel.w);
    return n;
}
#endif

int fetch_reference(int slot)
{
    return reference_at(slot);
}

void fetch_node_box(int node, out real3 lower, out real3 upper)
{
    lower = box_texel(2 * node).xyz;
    upper = box_texel(2 * node + 1).xyz;
}

/// Behind the boxes of all nodes.
int fetch_rope(int node, int face)
{
    return int(box_texel(2 * scene.limits.w + 2 * node + face / 3)[face % 3]);
}

#if KD_ENTRY
/// Where the walks that follow begin; rt_prim.glsl sets it for primary rays.
int walk_entry = 0;
int entry_node() { return walk_entry; }
#else
int entry_node() { return 0; }
#endif
int short_stack_entries() { return KD_SHORT_STACK; }

void fetch_bounds(out real3 lower, out real3 upper)
{
    lower = scene.bounds_lower.xyz;
    upper = scene.bounds_upper.xyz;
}

/// a[axes]; the axes are one of the three rotations, so that z tells all.
real3 rotate_axes(real3 a, int3 axes)
{
    return axes.z == 2 ? a : axes.z == 0 ? a.yzx : a.zxy;
}

void fetch_corners(int slot, int triangle, int3 axes, out real3 a, out real3 b, out real3 c)
{
#if KD_DUPLICATED
    if (slot >= 0) {
        a = rotate_axes(leaf_corner(3 * slot), axes);
        b = rotate_axes(leaf_corner(3 * slot + 1), axes);
        c = rotate_axes(leaf_corner(3 * slot + 2), axes);
        return;
    }
#endif
    a = rotate_axes(corner_at(3 * triangle), axes);
    b = rotate_axes(corner_at(3 * triangle + 1), axes);
    c = rotate_axes(corner_at(3 * triangle + 2), axes);
}

void fetch_normals(int triangle, out real3 a, out real3 b, out real3 c)
{
    a = texelFetch(kd_normals, 3 * triangle).xyz;
    b = texelFetch(kd_normals, 3 * triangle + 1).xyz;
    c = texelFetch(kd_normals, 3 * triangle + 2).xyz;
}

void fetch_texture_coordinates(int triangle, out real2 a, out real2 b, out real2 c)
{
    a = texelFetch(kd_uv, 3 * triangle).xy;
    b = texelFetch(kd_uv, 3 * triangle + 1).xy;
    c = texelFetch(kd_uv, 3 * triangle + 2).xy;
}

int fetch_material_index(int triangle)
{
#if KD_MATERIAL_NUMBERS
    return texelFetch(kd_material_index, triangle).x;
#else
    return scene.limits.z;
#endif
}

Material fetch_material(int index)
{
    int at = 5 * index;
    uvec4 first = texelFetch(kd_tables, at);
    uvec4 second = texelFetch(kd_tables, at + 1);
    uvec4 third = texelFetch(kd_tables, at + 2);
    Material m;
    m.diffuse = uintBitsToFloat(first.xyz);
    m.specular = uintBitsToFloat(second.xyz);
    m.reflectance = uintBitsToFloat(third.xyz);
    m.shininess = uintBitsToFloat(first.w);
    m.texture = int(second.w);
    m.emission = real3(0, 0, 0);
    m.emission_texture = -1;
    m.roughness = 0.0;
#if KD_EMISSION || KD_GLOSS
    uvec4 fourth = texelFetch(kd_tables, at + 3);
    m.roughness = uintBitsToFloat(fourth.w);
#endif
#if KD_EMISSION
    m.emission = uintBitsToFloat(fourth.xyz);
    m.emission_texture = int(third.w);
#endif
    m.normal_texture = -1;
    m.normal_scale = 1.0;
    m.alpha_cutoff = 0.0;
#if KD_NORMAL_MAPS || KD_MASKS
    uvec4 fifth = texelFetch(kd_tables, at + 4);
    m.normal_texture = int(fifth.x);
    m.normal_scale = uintBitsToFloat(fifth.y);
    m.alpha_cutoff = uintBitsToFloat(fifth.z);
#endif
    return m;
}

Light fetch_light(int index)
{
    int at = scene.counts.z + 4 * index;
    uvec4 first = texelFetch(kd_tables, at);
    uvec4 second = texelFetch(kd_tables, at + 1);
    uvec4 third = texelFetch(kd_tables, at + 2);
    uvec4 fourth = texelFetch(kd_tables, at + 3);
    Light light;
    light.kind = int(first.w);
    light.position = uintBitsToFloat(first.xyz);
    light.direction = uintBitsToFloat(second.xyz);
    light.colour = uintBitsToFloat(third.xyz);
    light.attenuation = uintBitsToFloat(fourth.xy);
    light.range = uintBitsToFloat(second.w);
    light.cos_inner = uintBitsToFloat(fourth.z);
    light.cos_outer = uintBitsToFloat(fourth.w);
    light.radius = uintBitsToFloat(third.w);
    return light;
}

TextureImage fetch_texture(int index)
{
    int4 image = int4(texelFetch(kd_tables, scene.counts.w + index));
    return TextureImage(image.x, image.y, image.z, image.w & 255, (image.w >> 8) & 255, image.w >> 16);
}

real4 fetch_texel(int index)
{
    return real4(texelFetch(kd_texels, index));
}

int triangle_count() { return scene.counts.x; }
int light_count() { return KD_LIGHTS < 0 ? scene.counts.y : KD_LIGHTS; }
int step_budget() { return scene.limits.x; }
bool scene_has_normals() { return KD_NORMALS != 0; }
bool scene_has_textures() { return KD_TEXTURES != 0; }
bool scene_has_mip_maps() { return KD_MIP_MAPS != 0; }
bool scene_has_wraps() { return KD_WRAPS != 0; }
bool scene_has_normal_maps() { return KD_NORMAL_MAPS != 0; }
bool scene_has_masks() { return KD_MASKS != 0; }
bool shadows_enabled() { return KD_SHADOWS != 0; }
bool scene_has_highlights() { return KD_HIGHLIGHTS != 0; }
bool scene_has_emission() { return KD_EMISSION != 0; }
bool scene_has_directional_lights() { return KD_DIRECTIONAL_LIGHTS != 0; }
bool scene_has_placed_lights() { return KD_PLACED_LIGHTS != 0; }
bool scene_has_spot_lights() { return KD_SPOT_LIGHTS != 0; }
bool scene_has_soft_shadows() { return KD_SOFT_SHADOWS != 0; }
bool scene_has_gloss() { return KD_GLOSS != 0; }
bool scene_has_indirect() { return KD_INDIRECT != 0; }
int sample_number() { return frame.sampling.x; }
uint sample_seed() { return uint(frame.sampling.y); }
real3 scene_ambient() { return scene.ambient.xyz; }
real3 scene_background() { return scene.background.xyz; }
