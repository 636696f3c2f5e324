// The list of traversals. To add one: write its file, then give it one line in each half of this list.
// C++ reads the upper half as a table: KD_TRAVERSAL(name, command-line name, the function that walks it as published or
// its own where no such form is kept, needs node boxes, needs stack, one sentence).

#ifdef KD_TRAVERSAL
KD_TRAVERSAL(naive, "naive", traverse_naive, false, false,
             "Tests every triangle, with no tree at all: the cost that a kd-tree is there to avoid.")
KD_TRAVERSAL(stack, "stack", published_stack, false, true,
             "Descends near child first and keeps far children on a stack: the paper's CPURT.")
KD_TRAVERSAL(restart, "restart", published_restart, false, false,
             "Starts again at the root after each leaf, because GPUs of 2005 had no stack (Foley & Sugerman): the paper's CPU Kd-restart and GPURT.")
KD_TRAVERSAL(backtrack, "backtrack", published_backtrack, true, false,
             "Climbs parent links after each leaf until a far child is left to visit (Foley & Sugerman).")
#else
#include "traverse_naive.glsl"
#include "traverse_stack.glsl"
#include "traverse_restart.glsl"
#include "traverse_backtrack.glsl"
#include "published_rule.glsl"
#include "published_stack.glsl"
#include "published_restart.glsl"
#include "published_backtrack.glsl"
#endif
