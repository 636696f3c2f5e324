// ShadePrim (paper, section 3.2.2): shades the primary hits, with one shadow ray per light.

void run_pass(int2 pixel)
{
    Path path = primary_path(pixel);
    bool has_work = path.hit.triangle >= 0;
    count_shaded(has_work);
    if (keeps_what_is_cleared && !has_work) return;
    Hit first_blocked = nothing_found();
    leave_colour(pixel, shade_path(path, first_blocked));
    leave_hit(pixel, first_blocked);
    leave_counters(pixel);
}
