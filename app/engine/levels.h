// Coarse first: which fractions of a picture's resolution are traced on the way to all of it.
#pragma once

namespace kd {

/// Remembers how fast frames were traced, and so how coarse the first one must be to come at once.
class LevelPlan {
  public:
    /// Of the first frame, which is never cancelled: a person who moves the camera sees every one.
    static constexpr double first_frame_ms = 15;
    /// A picture predicted to take less than this is traced without steps between.
    static constexpr double direct_ms = 250;
    /// A picture of a motion is traced as fine as it can be in this time.
    static constexpr double moving_ms = 200;
    static constexpr int coarsest = 32;

    /// Forgets the speed: another tree, traversal or machine.
    void reset() { ms_per_pixel_ = 0; }
    void learn(double milliseconds, int pixels);

    /// Scale of the first frame of a width x height picture: a power of two.
    [[nodiscard]] int first(int width, int height) const;
    /// Of the only frame of a picture that gives way to another at once.
    [[nodiscard]] int moving(int width, int height) const;
    /// Scale that follows `scale`; 1 is the last.
    [[nodiscard]] int next(int scale, int width, int height) const;
    /// 0 while the speed is not known.
    [[nodiscard]] double predicted_ms(int scale, int width, int height) const;

  private:
    double ms_per_pixel_ = 0;
};

/// Pixels along a side of `size` pixels at a scale.
[[nodiscard]] constexpr int scaled_size(int size, int scale) { return (size + scale - 1) / scale; }

}  // namespace kd
