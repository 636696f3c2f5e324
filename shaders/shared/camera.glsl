// Primary rays.

/// The ray through the centre of pixel (column, row) of a width x height image; row 0 is the top. Unit direction.
KD_FN Ray camera_ray(IN(PinholeCamera) camera, int2 pixel, int2 size)
{
    // One rounding each: in a frame far wider than high, an error of an ulp of 1 near the middle would be many pixels.
    real x = quotient(real(2 * pixel.x + 1 - size.x), real(size.x));
    real y = quotient(real(size.y - 2 * pixel.y - 1), real(size.y));
    Ray ray;
    ray.origin = camera.eye;
    ray.direction = normalise3(add_scaled3(add_scaled3(camera.forward, camera.right, x), camera.up, y));
    ray.t_min = real(0);
    ray.t_max = KD_T_LIMIT;
    ray.source = -1;
    return ray;
}
