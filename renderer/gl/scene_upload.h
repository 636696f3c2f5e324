// A scene and its tree in the context's memory.
#pragma once

#include <array>

#include "renderer/gl/blocks.h"
#include "renderer/gl/buffer_texture.h"
#include "renderer/gl/gl_limits.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/gl/uniform_buffer.h"
#include "renderer/kdtree/entry.h"
#include "renderer/scene/needs.h"

namespace kd {

class SceneUpload {
  public:
    /// Uploads what every configuration reads. InputError where a limit is passed, before anything is uploaded. Scene
    /// and tree must outlive this.
    SceneUpload(const GlApi& gl, const GlLimits& limits, const FlatScene& scene, const KdTree& tree);

    /// Uploads what else `needs` asks for and is not there yet, and lets go of what it does not. InputError where
    /// `config` cannot be traced.
    void prepare(const TraceConfig& config, const SceneNeeds& needs);

    /// As textures, and as storage buffers what walks read.
    void bind() const;
    void add_to(GlMemory& memory) const;

    [[nodiscard]] const FlatScene& scene() const { return scene_; }
    /// Where primary rays begin; after prepare() with the same configuration.
    [[nodiscard]] EntryPoints entries(const TraceConfig& config, const SeenArea& area) const {
        return entry_points(tree_, cells_, config, area);
    }
    [[nodiscard]] const SceneFacts& facts() const { return facts_; }

  private:
    void set_block(int step_budget, int only_material);
    void upload_references(bool wide);

    const GlApi& gl_;
    GlLimits limits_;
    const FlatScene& scene_;
    const KdTree& tree_;
    UploadSizes sizes_;
    SceneFacts facts_;
    std::vector<Aabb> cells_;           // of the nodes, where entry points are looked for
    std::array<int, 2> block_holds_{};  // step budget and only material
    bool wide_references_ = false, optimised_ropes_ = false;
    UniformBuffer<gl_blocks::SceneBlock> block_;
    BufferTexture corners_, tables_;
    BufferTexture nodes_, packed_nodes_, references_, material_index_, boxes_, boxes_and_ropes_, leaf_corners_,
        normals_, texture_coordinates_,
        texels_;  // as asked for
};

}  // namespace kd
