// The traversal that was chosen, under one name.

KD_FN void traverse(IN(Ray) ray, bool any_hit, INOUT(Hit) hit)
{
    RaySetup s = setup_ray(ray);
    Hit found = hit;
    found.t = hit.t - s.t_shift;
    KD_TRAVERSE(s, any_hit, found);
    if (found.triangle >= 0) {
        hit = found;
        hit.t = found.t + s.t_shift;
    }
}
