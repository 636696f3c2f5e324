// How each frame of a moving scene gets its tree.
#pragma once

#include <string>

#include "renderer/kdtree/build.h"

namespace kd {

/// The way that keeps an earlier tree's planes (renderer/kdtree/refit.h); every other is the name of a builder.
inline constexpr std::string_view refit_way = "refit";

/// One way, used by one thread at a time.
class TreeMaker {
  public:
    /// `way` is refit_way or a builder. Refitting begins with a tree that the builder of `config` makes of the
    /// triangles `at_rest`, and keeps that one's planes for all frames, so that a frame's tree is the same whichever
    /// frames came before. InputError as build_tree().
    TreeMaker(std::string way, const BuildConfig& config, std::span<const Triangle> at_rest, int threads);

    /// Where refitting is refused, the tree is built. Stopped early, it is not to be used. Of a tree that was refitted
    /// `report` tells the time alone.
    [[nodiscard]] KdTree make(std::span<const Triangle> triangles, const std::stop_token& stop = {},
                              BuildReport* report = nullptr);

    [[nodiscard]] const std::string& way() const { return way_; }
    /// Whose planes refitting keeps; empty where the way is a builder.
    [[nodiscard]] const KdTree& first() const { return first_; }
    /// Trees that were built because refitting was refused, and why the last one was.
    [[nodiscard]] int refused() const { return refused_; }
    [[nodiscard]] const std::string& why_refused() const { return why_refused_; }

  private:
    std::string way_;
    BuildConfig config_;
    int threads_;
    KdTree first_;
    std::size_t first_triangles_ = 0;
    int refused_ = 0;
    std::string why_refused_;
};

}  // namespace kd
