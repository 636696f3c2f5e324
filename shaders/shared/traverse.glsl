// The traversal that was chosen, under one name.

KD_FN void traverse(IN(Ray) ray, bool any_hit, INOUT(Hit) hit)
{
    KD_TRAVERSE(setup_ray(ray), any_hit, hit);
}
