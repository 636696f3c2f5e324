// The queues between kernels: 0 of rays that stand at a node, 1 of rays that stand at a leaf. renderer/gl/ray_queues.cpp knows
// the layout of the counts.

struct QueueCounts {
    uint groups[3]; // of glDispatchComputeIndirect
    uint taken;     // rays that the kernel of this queue works at
    uint pushed;    // rays that others have put in since
    uint unused[3];
};

layout(std430, binding = 6) restrict coherent buffer Counts { QueueCounts kd_counts[2]; };
layout(std430, binding = 7) restrict buffer Queues { int kd_queue[]; };

void push_ray(int queue, int slot)
{
    uint place = atomicAdd(kd_counts[queue].pushed, 1u);
    kd_queue[queue * frame.wave.x + int(place)] = slot;
}
