// ShadeRefl (paper, section 3.2.3): light along the mirror rays, added to the picture. ShadeIndirect:
// along scattered ones.

void run_pass(int2 pixel)
{
    Path path = reflected_path(pixel);
    // Where depth culls, it has culled the other pixels already.
    bool has_work = path_counts(path);
    count_shaded(has_work);
    if (keeps_what_is_cleared && !has_work) return;
    begin_counters(pixel);
    Hit first_blocked = earlier_hit(pixel);
    real3 colour = real3(0, 0, 0);
    if (has_work) colour = shade_path(path, first_blocked);
    add_colour(pixel, colour);
    leave_hit(pixel, first_blocked);
    leave_counters(pixel);
}
