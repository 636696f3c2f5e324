// The triangles of a leaf, of every ray that stands at one; then on to the next cell.

#include "walker.glsl"

void main()
{
    if (!take_ray(1)) return;
    on_leaf(walk_at);
    test_leaf(s, walk_node, hit);
    if (asked.any_hit && hit.triangle >= 0)
        complete_walk(hit);
    else
        leave_leaf(s, hit);
    put_ray(0);
}
