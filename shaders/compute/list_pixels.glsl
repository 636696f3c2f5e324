// Lists the pixels of the tile for which in_list() holds, which stands above; defines main(). One atomic per group: its
// pixels find their places by counting the bits before theirs.

#include "pixel_list.glsl"
#include "place_in_group.glsl"

layout(local_size_x = KD_GROUP_X, local_size_y = KD_GROUP_Y) in;

const uint lanes = uint(KD_GROUP_X * KD_GROUP_Y);
const uint words = (lanes + 31u) / 32u;
shared uint marks[words];
shared uint group_begin;

/// Makes room for so many pixels more, and lets the dispatch reach over them; returns where they begin.
uint append(uint count)
{
    uint begin = atomicAdd(kd_listed, count);
    uint groups = (begin + count + lanes - 1u) / lanes;
    atomicMax(kd_groups[0], min(groups, groups_in_a_row));
    atomicMax(kd_groups[1], (groups + groups_in_a_row - 1u) / groups_in_a_row);
    return begin;
}

/// How many pixels of this group are marked in the first `full` words and in the bits below `bit` of the next.
uint marked_before(uint full, uint bit)
{
    uint count = 0u;
    for (uint i = 0u; i < full; ++i) count += uint(bitCount(marks[i]));
    return bit == 0u ? count : count + uint(bitCount(marks[full] & ((1u << bit) - 1u)));
}

void main()
{
    uint lane = gl_LocalInvocationIndex;
    if (lane < words) marks[lane] = 0u;
    memoryBarrierShared();
    barrier();
    int2 pixel = frame.tile.xy + int2(gl_WorkGroupID.xy) * int2(KD_GROUP_X, KD_GROUP_Y) + place_in_group();
    bool listed = pixel.x < frame.tile.z && pixel.y < frame.tile.w && in_list(pixel);
    if (listed) atomicOr(marks[lane >> 5], 1u << (lane & 31u));
    memoryBarrierShared();
    barrier();
    if (lane == 0u) group_begin = append(marked_before(words, 0u));
    memoryBarrierShared();
    barrier();
    if (listed) kd_pixels[group_begin + marked_before(lane >> 5, lane & 31u)] = uint(pixel.x) | uint(pixel.y) << 16;
}
