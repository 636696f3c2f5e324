// The traversal that was chosen, under one name.

KD_FN void traverse(IN(Ray) ray, bool any_hit, INOUT(Hit) hit)
{
    RaySetup s = setup_ray(ray);
    real limit = hit.t;
    hit.t = limit - s.t_shift;
    KD_TRAVERSE(s, any_hit, hit);
    hit.t = hit.triangle >= 0 ? hit.t + s.t_shift : limit;
}
