// What a case of the stability suite works with: rays in the number asked for, the machines, and rows for the report.
#pragma once

#include <optional>

#include "renderer/kdtree/build.h"
#include "renderer/measure/compare.h"
#include "renderer/measure/oracle.h"
#include "renderer/measure/ray_machine.h"
#include "renderer/measure/stability/stability.h"
#include "renderer/scene/random.h"
#include "renderer/trace/traversal.h"

namespace kd {

/// Triangles with their tree.
struct Subject {
    FlatScene scene;
    KdTree tree;
    BuildReport built;
};

/// What the answers of a case have to be, besides those of brute force in single precision (which always count).
struct Expectation {
    bool every_ray_hits = false;              // closed around every origin
    std::optional<HitJudge> against_double;   // t, hit and triangle against double precision
    bool costly = false;                      // OpenGL gets every third ray
    bool may_give_up = true;                  // on OpenGL, in a case that is exempt; false: no ray is excused
    const std::vector<Hit>* known = nullptr;  // the answers themselves; brute force is not asked then
    std::string what;                         // names this part of the case in a failure
};

class CaseRun {
  public:
    struct Stopped {};
    /// How far the case is, 0..1 and never less than before, and what runs.
    using Tell = std::function<void(float, const std::string&)>;

    CaseRun(const StabilityCase& info, const StabilityConfig& config,
            std::span<const std::unique_ptr<RayMachine>> machines, std::stop_token stop, Tell tell = {});
    virtual ~CaseRun() = default;

    /// `full` with --long, a tenth of it otherwise, but at least 1000 where there are as many; of `parts` that share
    /// them, one's, rounded up.
    [[nodiscard]] std::size_t rays(std::size_t full, std::size_t parts = 1) const;
    /// Side of a square picture: `full` with --long, otherwise for a tenth of its pixels.
    [[nodiscard]] int side(int full) const;
    [[nodiscard]] bool long_run() const { return config_.long_run; }
    [[nodiscard]] Rules rules() const { return config_.rules; }
    [[nodiscard]] int threads() const { return config_.threads; }
    [[nodiscard]] unsigned seed() const { return config_.seed; }
    Random& random() { return random_; }
    [[nodiscard]] std::stop_token stop() const { return stop_; }
    /// Throws Stopped.
    void check_stop() const;

    /// A grey scene of these triangles and its tree, by the usual constants and the builder asked for where `build`
    /// does not say. A tree that validate() objects to is recorded as a failure.
    [[nodiscard]] Subject subject(std::vector<Triangle> triangles, const std::optional<BuildConfig>& build = {});
    [[nodiscard]] virtual Subject subject(FlatScene scene, const std::optional<BuildConfig>& build = {});

    /// What the loop over all triangles answers in single precision. Triangles whose boxes a ray does not come near are
    /// passed over; some of the rays go to the loop itself, and any difference is recorded as a failure. Throws
    /// Stopped.
    [[nodiscard]] std::vector<Hit> loop_hits(const FlatScene& scene, const std::vector<Ray>& rays);
    /// The same in double precision, unchecked.
    [[nodiscard]] std::vector<f64::Hit> exact_hits(const FlatScene& scene, const std::vector<Ray>& rays) const;

    /// Traces the rays with every traversal on every machine and adds to their rows.
    void check(const Subject& subject, const std::vector<Ray>& rays, const Expectation& expectation = {});

    /// Calls back with each traversal on each machine, loaded with the subject, and the row to add to: for what check()
    /// does not cover.
    /// A machine that the subject does not fit on is passed over and told in a row of its own if it `may_refuse`.
    enum class Refusal { is_an_error, may_refuse };
    /// OpenGL walks by those that the paper prints unless all are asked for, by --long too.
    enum class Walks { usual, all };
    using Use = std::function<void(RayMachine&, const TraceConfig&, StabilityRow&)>;
    void each(const Subject& subject, const Use& use, Refusal refusal = Refusal::is_an_error,
              Walks walks = Walks::usual);

    /// Judges the nearest hit of one of the rays, by its place among them; fail() tells the row what is wrong.
    using JudgeAnswer = std::function<void(std::size_t ray, const Hit& hit, StabilityRow& row)>;
    enum class Counted { here, by_check };
    /// The same with the nearest hit of each of these rays, which are counted in the row unless check() has.
    void each_answer(const Subject& subject, const std::vector<Ray>& rays, const JudgeAnswer& judge,
                     Counted counted = Counted::here);

    /// The nodes that a case about what nodes hold walks over: of both kinds, unless the walk needs one of them.
    [[nodiscard]] static std::vector<TraceConfig> with_both_nodes(TraceConfig trace);

    /// A row of its own, for what no traversal takes part in: `mismatches` of `n`, and why.
    void record(std::string_view what, std::int64_t n, std::int64_t mismatches, const std::string& reason = {});

    /// Tells the row how far t of these hits is off the planes of their triangles. It is told, not judged: a plane that
    /// is grazed, or where t is nearly 0, is met far from where it exactly is in units of the last place of t.
    static void tell_error_of_t(const FlatScene& scene, std::span<const Ray> rays, std::span<const Hit> hits,
                                StabilityRow& row);

    /// Adds one failure to a row, with the text of the first.
    static void fail(StabilityRow& row, const std::string& reason);

    /// The rows so far, with bounds and verdicts.
    [[nodiscard]] std::vector<StabilityRow> rows() const;

    /// The row of these names; of a walk that each() does not call back with.
    StabilityRow& row(std::string_view tracer, std::string_view context, std::string_view traversal);

  private:
    void use_whole(RayMachine& machine, const TraceConfig& trace, StabilityRow& r, const Use& use) const;
    /// The traversals that each() walks by.
    [[nodiscard]] std::vector<const TraversalInfo*> wanted_traversals(const RayMachine& machine, Walks walks) const;
    /// What the rays of check() are held against. `exact` is empty where the case does not ask for it.
    struct Reference {
        const FlatScene& scene;
        ReferenceRays loop;
        std::vector<f64::Hit> exact;
    };
    void check_machine(const Reference& reference, const Expectation& expectation, RayMachine& machine,
                       const TraceConfig& trace, StabilityRow& r) const;
    /// Of a case that is exempt: wrong answers of rays that were given up, and say so, are mismatches of their own
    /// kind. They get the right answers, so that what is compared from here on is what nothing excuses.
    static void excuse_given_up(const Reference& reference, std::span<const RayCounters> any_counters,
                                RayAnswers& found, StabilityRow& r);
    static void judge_exact(const Reference& reference, const std::vector<Hit>& found, const Expectation& expectation,
                            StabilityRow& row);

    const StabilityCase& info_;
    const StabilityConfig& config_;
    std::span<const std::unique_ptr<RayMachine>> machines_;
    std::stop_token stop_;
    Tell tell_;
    float done_ = 0;  // of the case, as far as it is known
    Random random_;
    std::vector<std::unique_ptr<StabilityRow>> rows_;
};

}  // namespace kd
