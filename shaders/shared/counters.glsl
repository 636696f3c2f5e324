// What one ray did, or several. CPU and GL must agree on every number exactly.

/// An interior visit is a re-visit (`interior_again`) when this ray has been at that node before.
struct RayCounters {
    uint interior_first;
    uint interior_again;
    uint leaves;
    uint triangle_tests;
    uint restarts;
    uint backtracks;
    uint stack_depth;
    uint exit_reason;
    uint rays;
};
