// kd-restart (Foley & Sugerman, Graphics Hardware 2005): no stack; after each leaf the walk begins again at the root.

KD_FN void traverse_restart(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    walk_from_top(s, any_hit, entry_node(), false, 0, step_budget(), hit);
}
