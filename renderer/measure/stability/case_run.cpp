#include "renderer/measure/stability/case_run.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "renderer/geometry/input_error.h"
#include "renderer/kdtree/validate.h"
#include "renderer/measure/path_rays.h"
#include "renderer/measure/stability/case_rays.h"
#include "renderer/measure/stability/distances.h"
#include "renderer/measure/timing.h"
#include "renderer/scene/stress_shapes.h"
#include "renderer/trace/counters.h"
#include "renderer/trace/upper_bound.h"

namespace kd {

namespace {

/// Whether of the walks that the paper prints this is the one of a case: they take turns, by its number.
bool on_turn(const TraversalInfo& walk, std::string_view id) {
    std::vector<Traversal> printed;
    for (const TraversalInfo& traversal : traversals())
        if (traversal.has_published_form()) printed.push_back(traversal.id);
    const auto turn = std::size_t(std::stoi(std::string(id.substr(1))));
    return printed[turn % printed.size()] == walk.id;
}

}  // namespace

CaseRun::CaseRun(const StabilityCase& info, const StabilityConfig& config,
                 std::span<const std::unique_ptr<RayMachine>> machines, std::stop_token stop, Tell tell)
    : info_(info), config_(config), machines_(machines), stop_(std::move(stop)), tell_(std::move(tell)),
      random_(case_seed(info.id, config.seed)) {}

std::size_t CaseRun::rays(std::size_t full, std::size_t parts) const {
    const std::size_t all = config_.long_run ? full : std::max((full + 9) / 10, std::min<std::size_t>(full, 1000));
    return (all + parts - 1) / parts;
}

int CaseRun::side(int full) const { return config_.long_run ? full : int(std::ceil(full / std::sqrt(10.0))); }

void CaseRun::check_stop() const {
    if (stop_.stop_requested()) throw Stopped{};
}

StabilityRow& CaseRun::row(std::string_view tracer, std::string_view context, std::string_view traversal) {
    const auto found = std::ranges::find_if(rows_, [&](const auto& r) {
        return r->tracer == tracer && r->context == context && r->traversal == traversal;
    });
    if (found != rows_.end()) return **found;
    rows_.push_back(std::make_unique<StabilityRow>());
    StabilityRow& made = *rows_.back();
    made.id = info_.id;
    made.tracer = tracer;
    made.context = context;
    made.traversal = traversal;
    return made;
}

Subject CaseRun::subject(std::vector<Triangle> triangles, const std::optional<BuildConfig>& build) {
    return subject(bare_scene(std::move(triangles)), build);
}

Subject CaseRun::subject(FlatScene scene, const std::optional<BuildConfig>& build) {
    check_stop();
    Subject made;
    made.scene = std::move(scene);
    const BuildConfig config = build.value_or(BuildConfig{.builder = config_.builder});
    made.tree = build_tree(made.scene.triangles, config, &made.built, {}, stop_);
    check_stop();
    for (const Violation& violation : validate(made.tree, made.scene.triangles, 1))
        record("tree", 1, 1, fmt::format("bad tree: node {}: {}", violation.node, violation.message));
    return made;
}

std::vector<const TraversalInfo*> CaseRun::wanted_traversals(const RayMachine& machine, Walks walks) const {
    // OpenGL runs the CPU's text, as T62 shows for every walk. All of them in all cases take nine minutes.
    const bool all = walks == Walks::all || config_.long_run || machine.on_cpu();
    // Its other tracers are no other walks: one of those in each case, by turns.
    const bool first = config_.gl.empty() || machine.tracer() == tracer_name(config_.gl.front());
    std::vector<const TraversalInfo*> found;
    for (const TraversalInfo& traversal : traversals()) {
        const auto& wanted = config_.traversals;
        const bool named = wanted.empty() || std::ranges::find(wanted, traversal.name) != wanted.end();
        const bool has_rules = config_.rules == Rules::robust || traversal.has_published_form();
        const bool asked =
            !wanted.empty() || all || (traversal.has_published_form() && (first || on_turn(traversal, info_.id)));
        const bool has_walk = machine.has_walk({.traversal = traversal.id, .rules = config_.rules});
        if (traversal.id != Traversal::naive && named && has_rules && asked && has_walk) found.push_back(&traversal);
    }
    return found;
}

/// What was traced in part says nothing: where stopped, the row stays as it was.
void CaseRun::use_whole(RayMachine& machine, const TraceConfig& trace, StabilityRow& r, const Use& use) const {
    const StabilityRow before = r;
    try {
        r.seconds += 1e-3 * wall_ms([&] { use(machine, trace, r); });
        check_stop();
    } catch (const Stopped&) {
        r = before;
        throw;
    }
}

/// How many parts a case has shows only when it ends, so each takes half of what is left, in equal steps.
void CaseRun::each(const Subject& subject, const Use& use, Refusal refusal, Walks walks) {
    std::size_t parts = 0;
    for (const auto& machine : machines_) parts += wanted_traversals(*machine, walks).size();
    const float step = 0.5f * (1 - done_) / float(std::max<std::size_t>(parts, 1));
    for (const auto& machine : machines_) {
        const std::vector<const TraversalInfo*> wanted = wanted_traversals(*machine, walks);
        try {
            machine->load(subject.scene, subject.tree);
        } catch (const InputError& error) {
            if (refusal == Refusal::is_an_error) throw;
            record(fmt::format("refused on {}", machine->context()), 1, 0, error.what());
            continue;
        }
        for (const TraversalInfo* traversal : wanted) {
            check_stop();
            if (tell_) tell_(done_, fmt::format("{}, {}", machine->tracer(), traversal->name));
            TraceConfig trace;
            trace.traversal = traversal->id;
            trace.rules = config_.rules;
            trace.nodes = config_.nodes;
            trace.packet_size = config_.packet_size;
            StabilityRow& r = row(machine->tracer(), machine->context(), traversal->name);
            use_whole(*machine, trace, r, use);
            done_ += step;
        }
    }
}

void CaseRun::each_answer(const Subject& subject, const std::vector<Ray>& rays, const JudgeAnswer& judge,
                          Counted counted) {
    each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& r) {
        std::vector<Hit> hits(rays.size());
        (void)machine.trace(trace, rays, false, hits, {}, stop_);
        check_stop();
        if (counted == Counted::here) {
            r.n += std::int64_t(rays.size());
            tell_error_of_t(subject.scene, rays, hits, r);
        }
        for (std::size_t i = 0; i < rays.size(); ++i) judge(i, hits[i], r);
    });
}

std::vector<Hit> CaseRun::loop_hits(const FlatScene& scene, const std::vector<Ray>& rays) {
    std::vector<Hit> hits = plain_nearest_hits(scene, TriangleBoxes(scene.triangles), rays, config_.threads, stop_);
    check_stop();
    constexpr std::size_t tests = 10'000'000, fewest = 10, most = 200;
    const std::size_t sample = std::clamp(tests / std::max<std::size_t>(scene.triangles.size(), 1), fewest, most);
    ReferenceRays all{rays, hits};
    const ReferenceRays some = all.every(rays.size() / sample + 1);
    const std::vector<Hit> plain = brute_force(scene, some.rays, config_.threads, stop_);
    check_stop();
    for (std::size_t i = 0; i < plain.size(); ++i)
        if (!bit_equal(plain[i], some.expected[i]))
            record("oracle", 1, 1,
                   fmt::format("ray {}: the loop finds {}; by boxes {}", exact_text(scene, some.rays[i]),
                               exact_text(scene, plain[i]), exact_text(scene, some.expected[i])));
    return hits;
}

std::vector<f64::Hit> CaseRun::exact_hits(const FlatScene& scene, const std::vector<Ray>& rays) const {
    std::vector<f64::Hit> hits = DoubleOracle(scene).nearest(rays, config_.threads, stop_);
    check_stop();
    return hits;
}

void CaseRun::check(const Subject& subject, const std::vector<Ray>& rays, const Expectation& expectation) {
    const FlatScene& scene = subject.scene;
    Reference all{scene, {rays, expectation.known ? *expectation.known : loop_hits(scene, rays)}, {}};
    if (expectation.against_double) all.exact = exact_hits(scene, rays);
    std::optional<Reference> third;
    if (expectation.costly) {
        third.emplace(Reference{scene, all.loop.every(3), {}});
        for (std::size_t i = 0; i < all.exact.size(); i += 3) third->exact.push_back(all.exact[i]);
    }
    each(subject, [&](RayMachine& machine, const TraceConfig& trace, StabilityRow& r) {
        check_machine(third && !machine.on_cpu() ? *third : all, expectation, machine, trace, r);
    });
}

void CaseRun::check_machine(const Reference& reference, const Expectation& expectation, RayMachine& machine,
                            const TraceConfig& trace, StabilityRow& r) const {
    const std::vector<Ray>& rays = reference.loop.rays;
    RayAnswers found(rays.size());
    const bool exempt = expectation.may_give_up && !info_.exempt.empty() && !machine.on_cpu();
    std::vector<RayCounters> any_counters(exempt ? rays.size() : 0);
    found.counters.resize(any_counters.size());
    (void)machine.trace(trace, rays, false, found.nearest, found.counters, stop_);
    (void)machine.trace(trace, rays, true, found.any, any_counters, stop_);
    check_stop();
    tell_error_of_t(reference.scene, rays, found.nearest, r);
    if (exempt) excuse_given_up(reference, any_counters, found, r);
    VerifyRow compared;
    compare_hits(reference.scene, reference.loop, found, compared);
    r.n += std::int64_t(rays.size());
    // Of several triangles at one distance the lowest number is hit, by every walk: here another one is wrong.
    r.mismatches += compared.mismatches + compared.ties;
    if (compared.mismatches > 0 && r.reason.empty()) r.reason = expectation.what + compared.first_failure;
    if (compared.ties > 0 && r.reason.empty())
        r.reason = expectation.what + "not the first of triangles at one distance";
    if (expectation.every_ray_hits)
        for (std::size_t i = 0; i < rays.size(); ++i)
            if (found.nearest[i].triangle < 0 && reference.loop.expected[i].triangle < 0)
                fail(r, fmt::format("{}missed by brute force too: ray {}", expectation.what,
                                    exact_text(reference.scene, rays[i])));
    if (!reference.exact.empty()) judge_exact(reference, found.nearest, expectation, r);
}

void CaseRun::excuse_given_up(const Reference& reference, std::span<const RayCounters> any_counters, RayAnswers& found,
                              StabilityRow& r) {
    const auto capped = [](const RayCounters& c) { return c.exit_reason == uint(KD_EXIT_STEP_CAP); };
    for (std::size_t i = 0; i < any_counters.size(); ++i) {
        const Hit& expected = reference.loop.expected[i];
        const bool nearest = capped(found.counters[i]) && !bit_equal(found.nearest[i], expected);
        const bool any = capped(any_counters[i]) && (found.any[i].triangle >= 0) != (expected.triangle >= 0);
        if (!nearest && !any) continue;
        fail(r, fmt::format("given up: ray {}: expected {}", exact_text(reference.scene, reference.loop.rays[i]),
                            exact_text(reference.scene, expected)));
        ++r.given_up;
        if (nearest) found.nearest[i] = expected;
        if (any) found.any[i] = expected;
    }
}

void CaseRun::judge_exact(const Reference& reference, const std::vector<Hit>& found, const Expectation& expectation,
                          StabilityRow& r) {
    const FlatScene& scene = reference.scene;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const HitError error = expectation.against_double->judge(found[i], reference.exact[i]);
        if (!is_wrong(error.verdict)) continue;
        fail(r, fmt::format("{}{} by {:.3g} ulp: ray {}: in double {}; found {}", expectation.what,
                            name_of(error.verdict), error.ulps, exact_text(scene, reference.loop.rays[i]),
                            exact_text(scene, reference.exact[i]), exact_text(scene, found[i])));
    }
}

std::vector<TraceConfig> CaseRun::with_both_nodes(TraceConfig trace) {
    std::vector<TraceConfig> both;
    for (const NodeEncoding nodes : {NodeEncoding::float4, NodeEncoding::packed}) {
        trace.nodes = nodes;
        if (nodes_in_force(trace) == nodes) both.push_back(trace);
    }
    return both;
}

void CaseRun::record(std::string_view what, std::int64_t n, std::int64_t mismatches, const std::string& reason) {
    StabilityRow& r = row("-", "-", what);
    // A failure's text comes before what was merely measured.
    if (r.reason.empty() || (r.mismatches == 0 && mismatches > 0)) r.reason = reason;
    r.n += n;
    r.mismatches += mismatches;
}

void CaseRun::tell_error_of_t(const FlatScene& scene, std::span<const Ray> rays, std::span<const Hit> hits,
                              StabilityRow& r) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].triangle < 0) continue;
        const double ulps = ulps_off_plane(rays[i], scene.triangles[std::size_t(hits[i].triangle)], double(hits[i].t));
        if (std::isfinite(ulps)) r.worst_ulp = std::max(r.worst_ulp, ulps);
    }
}

void CaseRun::fail(StabilityRow& r, const std::string& reason) {
    if (r.mismatches++ == 0) r.reason = reason;
}

std::vector<StabilityRow> CaseRun::rows() const {
    std::vector<StabilityRow> judged;
    for (const auto& r : rows_) {
        if (r->n == 0 && r->mismatches == 0) continue;  // not used by this case
        StabilityRow& row = judged.emplace_back(*r);
        row.upper95 = upper_bound_95(row.mismatches, row.n);
        row.verdict = row.mismatches == 0             ? Verdict::pass
                      : row.mismatches > row.given_up ? Verdict::fail
                                                      : Verdict::exempt;
        if (row.verdict == Verdict::exempt) row.reason = fmt::format("{}; {}", info_.exempt, row.reason);
    }
    return judged;
}

}  // namespace kd
