// RTRefl (paper, section 3.2.3): traces the mirror rays of paths that go on. Leaves a path of zero weight elsewhere.
// RTIndirect does the same with scattered rays.

void run_pass(int2 pixel)
{
    Path path = path_before_bounce(pixel);
    Path next = path;
    next.hit = nothing_found();
    next.weight = real3(0, 0, 0);
    // Where depth culls, it has culled the other pixels already.
    bool has_work = goes_on(path);
    count_shaded(has_work);
    if (keeps_what_is_cleared && !has_work) {
        end_path(pixel);
        return;
    }
    begin_counters(pixel);
    if (has_work) next = go_on(path);
    leave_path(pixel, next);
    leave_counters(pixel);
}
