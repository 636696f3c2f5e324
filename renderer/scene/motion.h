// How a scene moves.
#pragma once

namespace kd {

struct Scene;

/// Moves meshes, instances, lights and camera of the scene it belongs to (Scene::motion). What it draws from stays as
/// it is, so that several threads may pose copies of a scene at once, and a time gives the same bits whenever it is
/// asked for.
class Motion {
  public:
    Motion() = default;
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;
    virtual ~Motion() = default;

    /// Seconds until it begins again, above 0.
    [[nodiscard]] virtual double duration() const = 0;

    /// Moves `scene`, a copy of its own in any pose, to where it is at `seconds`, 0 to below duration(). Meshes, their
    /// triangles and instances keep their number and order. At 0 it is the scene as it was made.
    virtual void pose(Scene& scene, double seconds) const = 0;
};

}  // namespace kd
