// Push-down (Horn, Sugerman, Houston, Hanrahan, I3D 2007): kd-restart whose root sinks. While a ray has seen one child only
// of every node so far, nothing is left to visit outside of the cell that it is in, and there the walk begins again. Horn's
// rule stops at the first node with both; here the root also sinks behind nodes whose far child has been taken.

KD_FN void traverse_push_down(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    walk_from_top(s, any_hit, entry_node(), true, 0, step_budget(), hit);
}
