// What a program may be specialised by, with the values that stand where the host says nothing.

// 1: count what every ray does.
#ifndef KD_COUNTERS
#define KD_COUNTERS 1
#endif

// 1: nodes of 8 bytes, without parents, instead of the paper's float4.
#ifndef KD_PACKED_NODES
#define KD_PACKED_NODES 0
#endif

// 1: leaf lists of 32 bits an entry, 0: of 16. Textures tell by themselves.
#ifndef KD_WIDE_REFERENCES
#define KD_WIDE_REFERENCES 1
#endif

// 1: leaf lists hold copies of the triangles' corners instead of their numbers alone.
#ifndef KD_DUPLICATED
#define KD_DUPLICATED 0
#endif

// 1: what the scene has.
#ifndef KD_NORMALS
#define KD_NORMALS 1
#endif
#ifndef KD_TEXTURES
#define KD_TEXTURES 1
#endif
#ifndef KD_MIP_MAPS
#define KD_MIP_MAPS 1
#endif
#ifndef KD_WRAPS
#define KD_WRAPS 1
#endif
#ifndef KD_NORMAL_MAPS
#define KD_NORMAL_MAPS 1
#endif
#ifndef KD_MASKS
#define KD_MASKS 1
#endif
#ifndef KD_SHADOWS
#define KD_SHADOWS 1
#endif
#ifndef KD_REFLECTIONS
#define KD_REFLECTIONS 1
#endif
#ifndef KD_HIGHLIGHTS
#define KD_HIGHLIGHTS 1
#endif
#ifndef KD_EMISSION
#define KD_EMISSION 1
#endif
#ifndef KD_SOFT_SHADOWS
#define KD_SOFT_SHADOWS 1
#endif
#ifndef KD_GLOSS
#define KD_GLOSS 1
#endif
#ifndef KD_INDIRECT
#define KD_INDIRECT 1
#endif
#ifndef KD_DIRECTIONAL_LIGHTS
#define KD_DIRECTIONAL_LIGHTS 1
#endif
#ifndef KD_PLACED_LIGHTS
#define KD_PLACED_LIGHTS 1
#endif
#ifndef KD_SPOT_LIGHTS
#define KD_SPOT_LIGHTS 1
#endif

// How many lights there are; -1: as many as the scene's block says.
#ifndef KD_LIGHTS
#define KD_LIGHTS -1
#endif

// 0: all triangles have the material that the scene's block names.
#ifndef KD_MATERIAL_NUMBERS
#define KD_MATERIAL_NUMBERS 1
#endif

// The traversal, how many pending nodes its stack holds, and whether a trail of 32 levels is too short.
#ifndef KD_TRAVERSE
#define KD_TRAVERSE traverse_stack
#endif
#ifndef KD_TEST_LEAF
#define KD_TEST_LEAF test_leaf
#endif
#ifndef KD_STACK_SIZE
#define KD_STACK_SIZE 64
#endif
#ifndef KD_LONG_TRAIL
#define KD_LONG_TRAIL 1
#endif

// Where primary rays begin: 0 = at the root, 1 = at the node that the frame's block names, 2 = at that of their tile.
#ifndef KD_ENTRY
#define KD_ENTRY 0
#endif

// Entries that the short stack keeps.
#ifndef KD_SHORT_STACK
#define KD_SHORT_STACK 4
#endif

// How a walk decides: KD_RULES_ROBUST or another KD_RULES_... of shared/constants.glsl.
#ifndef KD_RULES
#define KD_RULES 0
#endif

// 0: the ray comes from the camera or is the first reflection; 1: it continues a path that a bounce has left.
#ifndef KD_LATER_BOUNCE
#define KD_LATER_BOUNCE 0
#endif

// 1: rt_refl and shade_refl do RTIndirect and ShadeIndirect: rays scatter from primary hits rather than mirror.
#ifndef KD_SCATTER
#define KD_SCATTER 0
#endif

// Depth of the quad, 0 near to 1 far.
#ifndef KD_QUAD_DEPTH
#define KD_QUAD_DEPTH 0.0
#endif

// 1: RTPrim writes the depths that the paper names (0 hit, 1 miss).
#ifndef KD_PUBLISHED_DEPTH
#define KD_PUBLISHED_DEPTH 0
#endif

// 1: count the pixels that are shaded.
#ifndef KD_COUNT_SHADED
#define KD_COUNT_SHADED 0
#endif

// 1: the driver's own quotients and roots may be off by a few units in the last place.
#ifndef KD_CORRECTED_ROUNDING
#define KD_CORRECTED_ROUNDING 0
#endif

// 1: fma rounds once.
#ifndef KD_FUSED
#define KD_FUSED 0
#endif

// 1: the driver ends loops after a number of iterations without a word, as llvmpipe does.
#ifndef KD_LOOP_LIMIT
#define KD_LOOP_LIMIT 0
#endif

// Compute shaders: pixels of a work group each way; 1: in Morton order; 1: what walks read lies in storage buffers, 0: in
// textures; 1: only pixels of a list, made by another kernel; 1: groups are dealt to a software renderer's threads.
#ifndef KD_GROUP_X
#define KD_GROUP_X 8
#endif
#ifndef KD_GROUP_Y
#define KD_GROUP_Y 8
#endif
#ifndef KD_MORTON
#define KD_MORTON 0
#endif
#ifndef KD_STORAGE
#define KD_STORAGE 1
#endif
#ifndef KD_LISTED
#define KD_LISTED 0
#endif
#ifndef KD_DEALT
#define KD_DEALT 0
#endif

// 0: rays walk where they are made; 1: they are put into queues, and nothing else is done; 2: their answers are read.
#ifndef KD_PHASE
#define KD_PHASE 0
#endif

// Of kernels that walk step by step: whose steps (0 stack, 1 restart, 2 backtrack, 3 push-down, 4 short stack, 5 ropes), the
// words of a ray's state at which its walk and its stack begin, and the queue that is planned.
#ifndef KD_STEPS
#define KD_STEPS 0
#endif
#ifndef KD_FOUND_WORD
#define KD_FOUND_WORD 12
#endif
#ifndef KD_WALK_WORD
#define KD_WALK_WORD 24
#endif
#ifndef KD_STACK_WORD
#define KD_STACK_WORD 32
#endif
#ifndef KD_QUEUE
#define KD_QUEUE 0
#endif
