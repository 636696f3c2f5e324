// ShadePrim (paper, section 3.2.2): shades the primary hits, with one shadow ray per light.

void run_pass(int2 pixel)
{
    Path path = primary_path(pixel);
    count_shaded(path.hit.triangle >= 0);
    Hit first_blocked = nothing_found();
    leave_colour(pixel, shade_path(path, first_blocked));
    leave_hit(pixel, first_blocked);
    leave_counters(pixel);
}
