// Between kernels: the rays that have been put into a queue are those that its kernel works at next.

#include "opengl/words.glsl"
#include "queues.glsl"

layout(local_size_x = 1) in;

void main()
{
    uint count = kd_counts[KD_QUEUE].pushed;
    uint lanes = uint(KD_GROUP_X * KD_GROUP_Y);
    kd_counts[KD_QUEUE].taken = count;
    kd_counts[KD_QUEUE].pushed = 0u;
    kd_counts[KD_QUEUE].groups[0] = (count + lanes - 1u) / lanes;
    kd_counts[KD_QUEUE].groups[1] = 1u;
    kd_counts[KD_QUEUE].groups[2] = 1u;
}
