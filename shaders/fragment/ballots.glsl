// Who else runs this instruction now, asked of the machine itself: lanes of the same SIMD group, counted by ballot.
// Before anything else of a shader, for it switches extensions on.

#if KD_BALLOTS == 1
#extension GL_ARB_gpu_shader_int64 : require
#extension GL_ARB_shader_ballot : require
#else
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#endif
// gl_HelperInvocation: lanes beside the picture's edge, that run for their neighbours' derivatives alone.
#extension GL_ARB_ES3_1_compatibility : require
#if KD_NV_THREAD_GROUP
#extension GL_NV_shader_thread_group : require
#endif

/// One bit per lane that is here.
uvec2 lanes_here()
{
#if KD_BALLOTS == 1
    return unpackUint2x32(ballotARB(true));
#else
    return subgroupBallot(true).xy;
#endif
}

uint lane_count()
{
#if KD_BALLOTS == 1
    return gl_SubGroupSizeARB;
#else
    return gl_SubgroupSize;
#endif
}

uint this_lane()
{
#if KD_BALLOTS == 1
    return gl_SubGroupInvocationARB;
#else
    return gl_SubgroupInvocationID;
#endif
}

/// The value of the lowest lane that is here.
uint of_first_lane(uint value)
{
#if KD_BALLOTS == 1
    return readFirstInvocationARB(value);
#else
    return subgroupBroadcastFirst(value);
#endif
}

/// The multiprocessor that this runs on, 0 where the driver does not tell.
uint this_multiprocessor()
{
#if KD_NV_THREAD_GROUP
    return gl_SMIDNV;
#else
    return 0u;
#endif
}

// Iterations that this lane has led, being the lowest lane in them, and the lanes that were in these iterations. Summed over
// the lanes of a group they are the group's iterations and its active lanes. [0] at interior nodes, [1] at leaves.
uint led_iterations[2] = uint[2](0u, 0u);
uint led_lanes[2] = uint[2](0u, 0u);

void count_lanes(int kind)
{
    uvec2 here = lanes_here();
    int lowest = here.x != 0u ? findLSB(here.x) : 32 + findLSB(here.y);
    if (lowest == int(this_lane())) {
        led_iterations[kind] += 1u;
        led_lanes[kind] += uint(bitCount(here.x) + bitCount(here.y));
    }
}
