// Short stack (Horn et al., I3D 2007) with a restart trail (Laine, HPG 2010): the last few far children are kept, older ones
// are found again from the top, which sinks as in push-down.

KD_FN void traverse_short_stack(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    walk_from_top(s, any_hit, entry_node(), true, short_stack_entries(), step_budget(), hit);
}
