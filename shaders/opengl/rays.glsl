// Traces rays from a table instead of a camera's.

void run_pass(int2 pixel)
{
    Hit hit = nothing_found();
    int index = pixel.y * frame.rays.z + pixel.x;
    // The last row may be longer than what is left.
    if (index < frame.rays.y) {
        Ray ray = fetch_ray(index);
        hit = no_hit(ray);
        traverse(ray, frame.rays.x != 0, hit);
    }
    leave_hit(pixel, hit);
    leave_counters(pixel);
}
