// Before a further bounce: raises the depth of pixels whose path ends here, so that the next quads skip them. The quad
// lies at the depth to be written.

#include "tracer.glsl"
#include "opengl/path_io.glsl"

void main()
{
    if (goes_on(reflected_path(this_pixel()))) discard;
}
