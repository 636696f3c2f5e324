#include "renderer/trace/rules.h"

namespace kd {

namespace {

constexpr RulesInfo table[] = {
    {Rules::robust, "robust",
     "Every cell that the ray comes near is visited, progress is by child, and hits are kept wherever they lie."},
    {Rules::as_published, "as-published",
     "The paper's section 2.3.2 to the letter: loses hits that touch split planes, and the triangles behind an origin "
     "on "
     "one."},
    {Rules::first_edition, "first-edition",
     "The first edition of Physically Based Rendering: the same trouble at other rays, and without a stack some walks "
     "never end."},
};

}  // namespace

std::span<const RulesInfo> all_rules() { return table; }

const RulesInfo& info(Rules rules) { return table[static_cast<std::size_t>(rules)]; }

}  // namespace kd
