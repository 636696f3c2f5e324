#include "renderer/trace/traversal.h"

namespace kd {

namespace {
constexpr TraversalInfo table[] = {
#define KD_TRAVERSAL(name, label, published, needs, summary, paragraph, source)                                        \
    {Traversal::name, label, "traverse_" #name, #published, needs, summary, paragraph, source},
#include "shaders/shared/traversals.glsl"
#undef KD_TRAVERSAL
};
}  // namespace

std::span<const TraversalInfo> traversals() { return table; }

const TraversalInfo& info(Traversal traversal) { return table[static_cast<std::size_t>(traversal)]; }

}  // namespace kd
