// Interior nodes until a leaf or the end, of every ray that stands at a node. New rays enter the tree here.

#include "walker.glsl"

void enter()
{
    asked.begun = true;
    keep_asked(slot, asked, true);
    hit = no_hit(asked.ray);
    hit.t -= s.t_shift;
#if KD_ENTRY
    walk_entry = asked.entry;
#endif
    begin_walk(s);
}

void main()
{
    if (!take_ray(0)) return;
    if (!asked.begun) enter();
    while (at_interior()) step_down(s, hit);
    put_ray(1);
}
