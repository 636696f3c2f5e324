// Primary rays.

/// The ray through the centre of pixel (column, row) of a width x height image; row 0 is the top. Unit direction.
KD_FN Ray camera_ray(IN(PinholeCamera) camera, int2 pixel, int2 size)
{
    PRECISE real x = quotient((real(pixel.x) + real(0.5)) * real(2), real(size.x)) - real(1);
    PRECISE real y = real(1) - quotient((real(pixel.y) + real(0.5)) * real(2), real(size.y));
    Ray ray;
    ray.origin = camera.eye;
    ray.direction = normalise3(add_scaled3(add_scaled3(camera.forward, camera.right, x), camera.up, y));
    ray.t_min = real(0);
    ray.t_max = KD_T_LIMIT;
    ray.source = -1;
    return ray;
}
