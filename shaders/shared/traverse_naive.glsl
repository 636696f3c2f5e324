// The loop over all triangles: no tree at all. Timed as a tracer of its own, and the reference for the others.

KD_FN void traverse_naive(IN(RaySetup) s, bool any_hit, INOUT(Hit) hit)
{
    if (!valid_ray(s.ray)) {
        on_exit(KD_EXIT_INVALID_RAY);
        return;
    }
    int count = triangle_count();
    int budget = step_budget();
    for (int triangle = 0; triangle < count; ++triangle) {
        if (triangle >= budget) {
            on_exit(KD_EXIT_STEP_CAP);
            return;
        }
        on_triangle(triangle);
        intersect_triangle(s, -1, triangle, hit);
        if (any_hit && hit.triangle >= 0) break;
    }
    finish_walk(hit);
}
