// Which pixels a group works at: a block of the tile, or with KD_LISTED a piece of a list.

#include "place_in_group.glsl"
#include "dealt_groups.glsl"
#include "pixel_list.glsl"

const uint places_in_group = uint(KD_GROUP_X * KD_GROUP_Y);

/// False past the tile's edges.
bool pixel_of_tile(int2 group, uint place, out int2 pixel)
{
    pixel = frame.tile.xy + group * int2(KD_GROUP_X, KD_GROUP_Y) + pixel_in_group(place);
    return pixel.x < frame.tile.z && pixel.y < frame.tile.w;
}

/// The pixel at a place of this group; false where there is none.
bool own_pixel(uint place, out int2 pixel)
{
#if KD_LISTED
    uint group = gl_WorkGroupID.y * groups_in_a_row + gl_WorkGroupID.x;
    return listed_pixel(dealt(group, gl_NumWorkGroups.x * gl_NumWorkGroups.y) * places_in_group + place, pixel);
#else
    return pixel_of_tile(int2(gl_WorkGroupID.x, dealt(gl_WorkGroupID.y, gl_NumWorkGroups.y)), place, pixel);
#endif
}
