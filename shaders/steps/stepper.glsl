// A walk that is made one step at a time, so that a loop outside of it decides which lanes step together. The walks are those
// of shaders/shared/traverse_...: the same steps in the same order, which tests hold them to.
//
// A file of walks defines: void begin_walk(IN(RaySetup) s)
//                          void step_down(IN(RaySetup) s, IN(Hit) hit)   one interior node, then arrive()
//                          void leave_leaf(IN(RaySetup) s, IN(Hit) hit)  to the next cell, then arrive(), or end_walk()

bool walking = false;
int walk_first = 0; // the node that the walk began at
int walk_at = 0;    // a node
KdNode walk_node;   // what it holds
int walk_slot = 0;  // of the triangle to test next
int walk_left = -1; // triangles of this leaf yet to test; -1 before the leaf itself is looked at
int walk_budget = 0;
real walk_begin = 0.0; // the part of the ray inside of the node's cell
real walk_end = 0.0;

bool at_interior()
{
    return walking && walk_node.flag != KD_LEAF;
}

bool at_leaf()
{
    return walking && walk_node.flag == KD_LEAF;
}

void end_walk(int reason)
{
    on_exit(reason);
    walking = false;
}

/// The walk has its answer.
void complete_walk(IN(Hit) hit)
{
    finish_walk(hit);
    walking = false;
}

void go_to(int node)
{
    walk_at = node;
    walk_node = fetch_node(node);
}

/// Takes what the leaf will cost out of the budget, as the walks do, and ends the walk where nothing is left.
void arrive()
{
    walk_left = -1;
    walk_budget -= walk_node.flag == KD_LEAF ? 1 + walk_node.count : 0;
    if (KD_OUT_OF_STEPS(walk_budget)) end_walk(KD_EXIT_STEP_CAP);
}

/// Enters the tree where walks begin; false, with the exit told, where the ray misses that.
bool enter_walk(IN(RaySetup) s)
{
    walk_first = entry_node();
    walking = enter_at(s, walk_first, walk_begin, walk_end);
    walk_budget = step_budget();
    if (walking) go_to(walk_first);
    return walking;
}
