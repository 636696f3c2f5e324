// The list of traversals. To add one: write its file, then give it one entry in each half of this list.
// C++ reads the upper half as a table: KD_TRAVERSAL(name, command-line name, the function that walks it as published or
// its own where no such form is kept, what it reads and keeps (renderer/trace/traversal.h), one sentence, a paragraph that
// explains it, its source).

#ifdef KD_TRAVERSAL
KD_TRAVERSAL(naive, "naive", traverse_naive, 0,
             "Tests every triangle, with no tree at all: the cost that a kd-tree is there to avoid.",
             "A loop over all triangles keeps the nearest hit. Its time grows with the scene and not with what a ray meets, "
             "so that a frame of ten thousand triangles takes thousands of times as long as with a tree. It has no rule "
             "that could err, and is what the others are held against.",
             "Whitted, An Improved Illumination Model for Shaded Display, CACM 23(6), 1980")
KD_TRAVERSAL(stack, "stack", published_stack, walk_stack,
             "Descends near child first and keeps far children on a stack: the paper's CPURT.",
             "At a node that the ray crosses on both sides of its plane, the child that comes first is walked at once and "
             "the other is put on a stack with its part of the ray. Behind a leaf the newest entry is next, unless it begins "
             "behind the nearest hit. No node is visited twice. Each ray needs room for as many entries as the tree has "
             "levels, which the shaders of 2006 did not have.",
             "Elhassan, An Analysis of GPU-based Interactive Raytracing, 2006, section 2.3.2")
KD_TRAVERSAL(restart, "restart", published_restart, walk_trail,
             "Starts again at the root after each leaf, because GPUs of 2005 had no stack (Foley & Sugerman): the paper's CPU Kd-restart and GPURT.",
             "Nothing is kept of the path. Behind a leaf the walk begins again at the root and goes to the next cell along "
             "the ray, so that the upper nodes are visited once for every leaf. Published, the next cell is the one behind "
             "the point where the ray left the last; here a trail of one bit per level says which far children have been "
             "taken, which rounding cannot disturb.",
             "Foley & Sugerman, KD-Tree Acceleration Structures for a GPU Raytracer, Graphics Hardware 2005; trail: Laine, HPG 2010")
KD_TRAVERSAL(backtrack, "backtrack", published_backtrack, walk_boxes | walk_parents,
             "Climbs parent links after each leaf until a far child is left to visit (Foley & Sugerman).",
             "Behind a leaf the walk goes up from child to parent until it finds a far child that the ray still meets, and "
             "down into that. Upper nodes are visited again only where they lie on that way. Every node needs a link to its "
             "parent, and its box to tell whether the ray meets it.",
             "Foley & Sugerman, KD-Tree Acceleration Structures for a GPU Raytracer, Graphics Hardware 2005")
KD_TRAVERSAL(push_down, "push-down", traverse_push_down, walk_trail,
             "Kd-restart whose root sinks: it starts again at the deepest cell outside of which nothing is left to visit.",
             "As long as a ray has met one child only of every node, all that it can still meet lies in the cell that it is "
             "in, and a restart may begin there rather than at the root. Rays that stay in a small part of the scene gain "
             "most. Horn's rule stops at the first node with two children to visit; here the root also sinks behind nodes "
             "whose near child is done.",
             "Horn, Sugerman, Houston, Hanrahan, Interactive k-D Tree GPU Raytracing, I3D 2007")
KD_TRAVERSAL(short_stack, "short-stack", traverse_short_stack, walk_trail | walk_short_stack,
             "A stack of a few entries, and a restart where it runs empty (Horn et al.).",
             "The last few far children are kept, and the oldest is forgotten where there is no room. Behind a leaf the "
             "newest is next; only when all that was kept is used up and something was forgotten the walk begins again, at "
             "the top that push-down gives it. Four entries are enough for nearly all rays, and fit into registers.",
             "Horn, Sugerman, Houston, Hanrahan, Interactive k-D Tree GPU Raytracing, I3D 2007; trail: Laine, HPG 2010")
KD_TRAVERSAL(ropes, "ropes", traverse_ropes, walk_trail | walk_boxes | walk_ropes,
             "Goes from leaf to leaf through links on their faces, and never up again (Popov et al.).",
             "Each face of a leaf has a link, its rope, to the smallest cell beyond it. Behind a leaf the walk follows the "
             "rope of the face that the ray leaves by and descends to the leaf behind. Nothing is kept but the place. Six "
             "links and a box per leaf take several times the memory of the tree. Rays that pass an edge of a cell too close "
             "to tell the sides apart are walked by kd-restart.",
             "Popov, Guenther, Seidel, Slusallek, Stackless KD-Tree Traversal for High Performance GPU Ray Tracing, Computer Graphics Forum 26(3), 2007")
#else
#include "traverse_naive.glsl"
#include "traverse_stack.glsl"
#include "trail.glsl"
#include "walk_from_top.glsl"
#include "traverse_restart.glsl"
#include "traverse_backtrack.glsl"
#include "traverse_push_down.glsl"
#include "traverse_short_stack.glsl"
#include "traverse_ropes.glsl"
#include "published_rule.glsl"
#include "published_stack.glsl"
#include "published_restart.glsl"
#include "published_backtrack.glsl"
#endif
