#include "app/error_time/error_time_tables.h"

#include <fmt/format.h>

#include "viz/csv.h"

namespace kd {

std::string scene_csv(const ErrorTimeResults& results) {
    std::string text = "scene,files,contents,notes\n";
    for (const SceneErrorTime& scene : results.scenes)
        text +=
            csv_row(scene.name.shown, scene.name.stem, scene.contents, fmt::format("{}", fmt::join(scene.notes, "; ")));
    return text;
}

std::string image_csv(const ImageReport& report) {
    std::string text =
        "sampler,machine,traversal,samples,seconds,seconds_p25,seconds_p75,rmse,rmse_low,rmse_high,own_rmse,flip,"
        "flip_low,flip_high,on_front\n";
    for (const ImageCurve& c : report.curves)
        for (const ImagePoint& p : c.points)
            text += csv_row(name_of(c.sampler), c.machine, c.traversal, p.samples, p.seconds, p.quartiles.low,
                            p.quartiles.high, p.rmse, p.rmse_interval.low, p.rmse_interval.high, p.own_rmse, p.flip,
                            p.flip_interval.low, p.flip_interval.high, p.on_front);
    return text;
}

std::string slope_csv(const ImageReport& report) {
    std::string text =
        "sampler,machine,traversal,clock,slope,slope_low,slope_high,frame_ms,frame_ms_p25,frame_ms_p75,"
        "frames,clock_discrepancy,frame_ratio,frame_ratio_low,frame_ratio_high,frame_ratio_confidence,largest_gap,"
        "largest_gap_of_machine\n";
    for (const ImageCurve& c : report.curves)
        text += csv_row(name_of(c.sampler), c.machine, c.traversal, c.clock, c.fit.slope, c.fit.interval.low,
                        c.fit.interval.high, c.frame.median_ms, c.frame.p25_ms, c.frame.p75_ms, c.frame.samples,
                        c.clock_discrepancy, c.of_first.median, c.of_first.low, c.of_first.high, c.of_first.confidence,
                        c.worst_gap, c.own_gap);
    return text;
}

std::string hit_csv(const HitReport& report) {
    std::string text =
        "family,triangle_test,precision,rules,traversal,rays,missed,wrong,per_million,per_million_upper95,"
        "ulp_p50,ulp_p999,ulp_largest,ns_per_ray,ns_p25,ns_p75,rounds,time_ratio,time_ratio_low,time_ratio_high,"
        "time_ratio_confidence,on_front\n";
    for (const HitRow& r : report.rows)
        text +=
            csv_row(r.family, triangle_test_names[std::size_t(r.method.test)], r.method.in_double ? "double" : "float",
                    info(r.method.rules).name, info(r.method.traversal).name, r.n, r.missed, r.wrong, r.per_million(),
                    1e6 * r.upper95, r.ulp_p50, r.ulp_p999, r.ulp_most, r.ns, r.quartiles.low, r.quartiles.high,
                    r.rounds, r.of_first.median, r.of_first.low, r.of_first.high, r.of_first.confidence, r.on_front);
    return text;
}

std::string tree_csv(const TreeReport& report) {
    std::string text =
        "builder,leaf_size,bins,nodes,references,reference_cap_hit,sah_cost,expected_interior,expected_tests,"
        "lines,line_cost,line_cost_standard_error,line_interior,line_tests";
    for (const auto name : ray_names)
        text += fmt::format(",cost_per_{}_ray", name == "reflection shadow" ? "reflection_shadow" : name);
    text +=
        ",build_ms,build_ms_p25,build_ms_p75,builds,frame_ms,frame_ms_p25,frame_ms_p75,frames,sah_ratio,frame_ratio,"
        "frame_ratio_low,frame_ratio_high,frame_ratio_confidence,break_even_frames,on_front,is_reference";
    for (const char* what : {"line_cost_ratio", "line_interior_ratio", "line_test_ratio"})
        text += fmt::format(",{0},{0}_low,{0}_high", what);
    text += ",break_even_frames_low,break_even_frames_high\n";
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const TreeRow& r = report.rows[i];
        const double lines = double(std::max<std::int64_t>(r.lines.rays, 1));
        std::array<std::optional<double>, pass_count> cost;
        for (std::size_t pass = 0; pass < pass_count; ++pass)
            if (report.rays[pass] > 0) cost[pass] = r.cost_per_ray[pass];
        const auto& [lines_cost, lines_interior, lines_tests] = r.line_ratios;
        const auto paid = r.break_even_frames ? std::optional(r.break_even_interval) : std::nullopt;
        text += csv_row(
            r.builder, r.leaf_size, r.bins > 0 ? std::optional(r.bins) : std::nullopt, r.stats.nodes,
            r.stats.references, r.cap_hit, r.stats.sah_cost, r.stats.expected_interior_visits,
            r.stats.expected_triangle_tests, r.lines.rays, r.lines.mean_cost(), r.lines.standard_error(),
            r.lines.interior / lines, r.lines.tests / lines, cost[0], cost[1], cost[2], cost[3], r.build.median_ms,
            r.build.p25_ms, r.build.p75_ms, r.build.samples, r.frame.median_ms, r.frame.p25_ms, r.frame.p75_ms,
            r.frame.samples, r.sah_ratio, r.frame_ratio.median, r.frame_ratio.low, r.frame_ratio.high,
            r.frame_ratio.confidence, r.break_even_frames, r.on_front, i == report.reference, lines_cost.ratio,
            lines_cost.interval.low, lines_cost.interval.high, lines_interior.ratio, lines_interior.interval.low,
            lines_interior.interval.high, lines_tests.ratio, lines_tests.interval.low, lines_tests.interval.high,
            paid ? std::optional(paid->low) : std::nullopt, paid ? std::optional(paid->high) : std::nullopt);
    }
    return text;
}

std::string tau_csv(const TreeReport& report) {
    std::string text = "of,trees,tau,tau_low,tau_high\n";
    const auto add = [&](const std::string& of, const RankCorrelation& correlation) {
        text += csv_row(of, report.rows.size(), correlation.tau, correlation.interval.low, correlation.interval.high);
    };
    for (std::size_t pass = 0; pass < pass_count; ++pass)
        if (report.tau[pass]) add(fmt::format("{} rays", ray_names[pass]), *report.tau[pass]);
    add("frame time", report.frame_tau);
    return text;
}

std::string truncation_csv(const TruncationReport& report) {
    std::string text =
        "limited,machine,traversal,clock,limit,frame_ms,frame_ms_p25,frame_ms_p75,frames,rmse,given_up_pixels,on_front,"
        "most_steps\n";
    for (const TruncationCurve& c : report.curves)
        for (const TruncationPoint& p : c.points)
            text +=
                csv_row(name_of(c.what), c.machine, c.traversal, c.clock, p.limit, p.frame.median_ms, p.frame.p25_ms,
                        p.frame.p75_ms, p.frame.samples, p.rmse, p.given_up, p.on_front, c.most_steps);
    return text;
}

std::string effect_csv(const EffectReport& report) {
    std::string text =
        "effect,points,machine,samples,average_samples,asked_error,seconds,seconds_p25,seconds_p75,relmse,relmse_low,"
        "relmse_high,rmse,on_front\n";
    for (const MeasuredEffect& e : report.effects)
        for (const EffectCurve& c : e.curves)
            for (const EffectPoint& p : c.points)
                text += csv_row(e.effect.name, name_of(c.light_points), c.machine, p.samples, p.average_samples,
                                p.asked_error > 0 ? std::optional(p.asked_error) : std::nullopt, p.seconds,
                                p.quartiles.low, p.quartiles.high, p.relative_mse, p.relative_mse_interval.low,
                                p.relative_mse_interval.high, p.rmse, p.on_front);
    return text;
}

std::string effect_slope_csv(const EffectReport& report) {
    std::string text =
        "effect,points,machine,clock,slope,slope_low,slope_high,frame_ms,frame_ms_p25,frame_ms_p75,frames,largest_gap,"
        "reference_relmse,reference_rmse\n";
    for (const MeasuredEffect& e : report.effects)
        for (const EffectCurve& c : e.curves)
            if (c.light_points != LightPoints::adaptive)
                text += csv_row(e.effect.name, name_of(c.light_points), c.machine, c.clock, c.fit.slope,
                                c.fit.interval.low, c.fit.interval.high, c.frame.median_ms, c.frame.p25_ms,
                                c.frame.p75_ms, c.frame.samples, c.gap, e.reference_relative_mse, e.reference_rmse);
    return text;
}

std::string ShownNumbers::operator()(const std::string& name, double value, const char* format) {
    return shown(name, value, fmt::format(fmt::runtime(format), value));
}

std::string ShownNumbers::ratio(const std::string& name, const MedianInterval& value) {
    return ratio_text(value, [&](const char* part, double number) {
        return shown(name + ", " + part, number, short_number(number));
    });
}

std::string ShownNumbers::shown(const std::string& name, double value, std::string text) {
    entries_.push_back({name, std::move(text), value});
    return fmt::format("<data value=\"{}\">{}</data>", value, entries_.back().text);
}

std::string ShownNumbers::csv() const {
    std::string text = "name,shown,value\n";
    for (const Entry& entry : entries_) text += csv_row(entry.name, entry.text, entry.value);
    return text;
}

}  // namespace kd
