// Hits held against exact ones: what the oracle's maps show.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/trace/frame.h"

namespace kd {

/// True for rays whose nearest hit a frame holds: primary rays, and reflections at their first bounce. Shadow rays stop
/// at the first triangle found.
[[nodiscard]] constexpr bool has_nearest_hits(Pass rays) { return rays == Pass::rt_prim || rays == Pass::rt_refl; }

/// How a hit compares with the exact one. `tie`: another answer than the exact one where neither is wrong (another
/// triangle at the same distance, or an edge passed closer than single precision can tell). `unfinished`: the walk was
/// given up. `none`: no ray was traced here, or nothing was compared yet.
enum class HitVerdict : std::uint8_t {
    agrees,
    tie,
    missed,
    false_hit,
    wrong_triangle,
    wrong_t,
    unfinished,
    none,
};
/// All but `none`, which has no count.
inline constexpr std::size_t verdict_count = 7;
inline constexpr std::array<std::string_view, verdict_count> verdict_names{
    "agrees", "tie", "missed", "false hit", "wrong triangle", "t off", "unfinished"};

[[nodiscard]] constexpr bool is_wrong(HitVerdict verdict) {
    return verdict >= HitVerdict::missed && verdict <= HitVerdict::unfinished;
}
/// "not compared" for `none`.
[[nodiscard]] std::string_view name_of(HitVerdict verdict);

struct JudgedHit {
    HitVerdict verdict = HitVerdict::none;
    /// Error of t in units in the last place of the exact one; infinite where only one of the two hit or the walk was
    /// given up, 0 where both missed.
    double ulps = 0;
    f64::Hit exact{-1, 0.0, 0.0, 0.0};
};

using VerdictCounts = std::array<std::int64_t, verdict_count>;

/// ": 2 missed, 1 wrong triangle", of the wrong ones that there are; nothing where all is right.
[[nodiscard]] std::string wrong_text(const VerdictCounts& counts);

/// The hits of one pass's rays, judged pixel by pixel.
struct JudgedLayer {
    Pass rays = Pass::rt_prim;
    int step = 1;  // every so many pixels along both sides are judged: x of `hits` is the frame's x * step
    Image<JudgedHit> hits;
    VerdictCounts counts{};                // as tally() finds them
    double worst_ulps = 0;                 // of t among the pixels that are right
    std::vector<std::size_t> places = {};  // where rays go wrong: wrong_places() of `hits`

    /// Fills `counts`, `worst_ulps` and `places`.
    void tally();
    [[nodiscard]] std::int64_t compared() const;
    [[nodiscard]] std::int64_t wrong() const;
};

}  // namespace kd
