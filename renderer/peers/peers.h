// Other ray tracers in the same program, over the same triangles and arrays of rays: what bench --peers compares with.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/scene.h"

namespace kd {

/// What the peer is told about its rays.
struct PeerQuery {
    bool any_hit = false;  // hit or miss is all that is asked
    bool coherent = true;  // neighbours go alike
    int threads = 1;       // 0 = all
};

class PeerTracer {
  public:
    virtual ~PeerTracer() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;  // "embree-16-robust"
    [[nodiscard]] virtual int width() const = 0;              // rays that it takes at once
    [[nodiscard]] virtual bool robust() const = 0;            // claims that rays do not slip through edges
    /// Answers `rays` into `hits`, as long; taking them and giving their hits back in kdscope's form is part of it.
    /// Where any hit will do, only whether `triangle` is negative means something.
    virtual void trace(std::span<const Ray> rays, const PeerQuery& query, std::span<Hit> hits) const = 0;
};

/// "Embree 3.13.5"; empty where this program was built without.
[[nodiscard]] std::string peers_version();

/// Each over a structure of its own, built for quality, of the scene's triangles; none where built without. The scene
/// need not outlive them.
[[nodiscard]] std::vector<std::unique_ptr<PeerTracer>> make_peers(const FlatScene& scene);

}  // namespace kd
