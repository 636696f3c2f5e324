// The observer hooks of shaders/shared/kernel.glsl: RayCounters, summed over the rays of one invocation.

RayCounters counters = RayCounters(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);

#if KD_COUNTERS
void on_interior(int node, bool again)
{
    counters.interior_first += again ? 0u : 1u;
    counters.interior_again += again ? 1u : 0u;
}
void on_leaf(int node) { ++counters.leaves; }
void on_triangle(int slot) { ++counters.triangle_tests; }
void on_push(int depth) { counters.stack_depth = max(counters.stack_depth, uint(depth)); }
void on_restart() { ++counters.restarts; }
void on_backtrack() { ++counters.backtracks; }
void flag(int reason) { counters.exit_reason = max(counters.exit_reason, uint(reason)); }
void on_exit(int reason)
{
    flag(reason);
    ++counters.rays;
}
#else
void on_interior(int node, bool again) {}
void on_leaf(int node) {}
void on_triangle(int slot) {}
void on_push(int depth) {}
void on_restart() {}
void on_backtrack() {}
void flag(int reason) {}
void on_exit(int reason) {}
#endif

/// Tells a step cap where the driver has ended a loop of this invocation on its own. llvmpipe then lets every further
/// loop run one round only, so a loop of a few known rounds finds out. Called after all tracing.
void check_loops()
{
#if KD_LOOP_LIMIT
    int rounds = 0;
    while (rounds < scene.limits.y) ++rounds;
    if (rounds < scene.limits.y) flag(KD_EXIT_STEP_CAP);
#endif
}

/// Of a ray of the same invocation.
void add_counters(RayCounters other)
{
    counters.interior_first += other.interior_first;
    counters.interior_again += other.interior_again;
    counters.leaves += other.leaves;
    counters.triangle_tests += other.triangle_tests;
    counters.restarts += other.restarts;
    counters.backtracks += other.backtracks;
    counters.stack_depth = max(counters.stack_depth, other.stack_depth);
    counters.exit_reason = max(counters.exit_reason, other.exit_reason);
    counters.rays += other.rays;
}

/// Counters as two texels. The exit reason takes the lowest three bits of its word, the rays the others.
uvec4 first_counters()
{
    return uvec4(counters.interior_first, counters.interior_again, counters.leaves, counters.triangle_tests);
}

uvec4 second_counters()
{
    return uvec4(counters.restarts, counters.backtracks, counters.stack_depth,
                 counters.exit_reason | counters.rays << 3u);
}

RayCounters unpack_counters(uvec4 a, uvec4 b)
{
    return RayCounters(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w & 7u, b.w >> 3u);
}
