// A scene and its tree in the context's memory.
#pragma once

#include "renderer/gl/blocks.h"
#include "renderer/gl/buffer_texture.h"
#include "renderer/gl/gl_limits.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/gl/uniform_buffer.h"
#include "renderer/scene/needs.h"

namespace kd {

class SceneUpload {
  public:
    /// Uploads what every configuration reads. InputError where a limit is passed, before anything is uploaded. Scene and
    /// tree must outlive this.
    SceneUpload(const GlApi& gl, const GlLimits& limits, const FlatScene& scene, const KdTree& tree);

    /// Uploads what else `config` reads and is not there yet. InputError where it cannot be traced.
    void prepare(const TraceConfig& config, const SceneNeeds& needs);

    void bind() const;
    void add_to(GlMemory& memory) const;

    [[nodiscard]] const FlatScene& scene() const { return scene_; }
    /// Room for pending nodes that the stack traversal needs on this tree, rounded up to one of a few sizes so that few
    /// programs serve all trees.
    [[nodiscard]] int stack_size() const { return stack_size_; }

  private:
    void set_step_budget(int wanted);

    const GlApi& gl_;
    GlLimits limits_;
    const FlatScene& scene_;
    const KdTree& tree_;
    UploadSizes sizes_;
    int stack_size_;
    int step_budget_ = 0;
    UniformBuffer<gl_blocks::SceneBlock> block_;
    BufferTexture nodes_, references_, corners_, material_index_, tables_;
    BufferTexture boxes_, leaf_corners_, normals_, texture_coordinates_, texels_;  // where asked for
};

}  // namespace kd
