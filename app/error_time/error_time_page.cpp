#include "app/error_time/error_time_page.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/error_time/error_time_charts.h"
#include "app/error_time/error_time_tables.h"
#include "app/report/chart_files.h"
#include "app/report/html.h"
#include "renderer/io/file.h"
#include "viz/csv.h"

namespace kd {

namespace {

using Cells = std::vector<std::string>;

/// Why there is no frame from which on a tree pays whose frames take `ratio` times less: what the interval shows, no
/// more.
std::string never_pays_text(const MedianInterval& ratio) {
    switch (verdict_of(ratio)) {
        case RatioVerdict::none: return "not timed";
        case RatioVerdict::too_few: return "too few rounds to say";
        case RatioVerdict::no_difference: return "no difference seen";
        default: return "never: its frames are slower";
    }
}

class Page {
  public:
    Page(std::filesystem::path folder, const ErrorTimeResults& results, const std::stop_token& stop)
        : folder_(std::move(folder)), results_(results), measured_on_(results.on.lines()), stop_(stop) {}

    std::vector<std::string> write() {
        html_ = "<h1>Error against run time</h1>\n<p>The diagrams of P1, P2 and P4 have what a method takes along x "
                "and how "
                "far off it is along y, both logarithmic: lower left is better, and a ring marks what nothing beats "
                "in both. "
                "Those of P3 hold a prediction against what is paid, which is neither.</p>\n";
        if (!can_draw_charts()) html_ += fmt::format("<p>{}.</p>\n", no_gnuplot_text);
        html_ += "<p class=\"small\">";
        for (const std::string& line : measured_on_) html_ += html_text(line) + "<br>\n";
        html_ += fmt::format("All of it took {} s; {} s were aimed at.</p>\n",
                             number_("all, seconds", results_.seconds, "{:.0f}"),
                             number_("all, seconds aimed at", results_.config.seconds, "{:.0f}"));
        save("scenes.csv", csv_comments(measured_on_) + scene_csv(results_));
        if (results_.config.wants(ErrorReport::p1)) write_p1();
        if (results_.hits) write_p2(*results_.hits);
        if (results_.config.wants(ErrorReport::p3)) write_p3();
        if (results_.config.wants(ErrorReport::p4)) write_p4();
        save("numbers.csv", csv_comments(measured_on_) + number_.csv());
        save("left-out.csv", csv_comments(measured_on_) + left_out_csv_);
        html_ += "<p class=\"small\">Every number above stands in <a href=\"numbers.csv\">numbers.csv</a> by its name; "
                 "<a href=\"scenes.csv\">scenes.csv</a> tells the scenes, <a href=\"left-out.csv\">left-out.csv</a> "
                 "what was left out.</p>\n";
        save("index.html", html_page("kdscope: error against run time", html_));
        return names_;
    }

  private:
    void save(const std::string& name, const std::string& bytes) {
        write_file(folder_ / name, bytes);
        names_.push_back(name);
    }

    void save_table(const std::string& name, const std::string& csv) {
        save(name, csv_comments(measured_on_) + csv);
        html_ += fmt::format("<p class=\"small\">All its numbers: <a href=\"{0}\">{0}</a></p>\n", html_text(name));
    }

    void show(const std::vector<ErrorFigure>& figures) {
        html_ += "<div class=\"figures\">\n";
        for (const ErrorFigure& figure : figures) {
            const std::vector<std::string> files = write_chart(folder_, figure.name, figure.chart, measured_on_, stop_);
            names_.insert(names_.end(), files.begin(), files.end());
            html_ += html_chart(figure.name, figure.chart.title, "", files.size() > 1);
        }
        html_ += "</div>\n";
    }

    void left_out(ErrorReport report, const std::string& what, const std::string& why) {
        left_out_csv_ += csv_row(error_report_names[std::size_t(report)], what, why);
        html_ += fmt::format("<p><b>Left out</b> for {}: {}.</p>\n", html_text(what), html_text(why));
    }

    /// A heading for each scene, what is left out for it, and what `write` makes of it.
    template <class Write>
    void each_scene(ErrorReport report, const Write& write) {
        for (const SceneErrorTime& scene : results_.scenes) {
            html_ += fmt::format("<h3>{}</h3>\n", html_text(scene.name.shown));
            for (const LeftOut& left : scene.left_out)
                if (left.report == report) left_out(report, scene.name.shown, left.why);
            write(scene);
        }
    }

    std::string range(const std::string& name, double low, double high, const char* format) {
        return number_(name + ", from", low, format) + " to " + number_(name + ", to", high, format);
    }

    void write_p1() {
        html_ +=
            "<h2>P1: image error against time</h2>\n<p>More samples per pixel bring an image nearer to the converged "
            "one, whose reference is computed in double precision from samples of its own; random samples by the root "
            "of their number (slope −0.5), stratified ones faster. Traversals find the same hits, so their curves are "
            "one curve shifted sideways by their speed: a gap along y would be a fault.</p>\n";
        each_scene(ErrorReport::p1, [&](const SceneErrorTime& scene) {
            if (scene.images && !scene.images->curves.empty()) write_images(scene);
        });
    }

    void write_images(const SceneErrorTime& scene) {
        const ImageReport& report = *scene.images;
        const std::string at = scene.name.shown + ": P1: ";
        html_ += fmt::format(
            "<p>{}. {} x {} pixels, up to {} samples each, {} sets of random ones; the reference has {} and is itself "
            "off by about {}. Size and samples are what fits into the time aimed at. RMSE is of the colours that the "
            "tracers compute, neither rounded nor clipped; FLIP (Andersson et al. 2020) of the same as "
            "displayed.</p>\n",
            html_text(scene.contents), number_(at + "width", report.plan.width, "{:.0f}"),
            number_(at + "height", report.plan.height, "{:.0f}"),
            number_(at + "most samples", report.plan.most_samples, "{:.0f}"),
            number_(at + "sets", report.plan.sets, "{:.0f}"),
            number_(at + "reference samples", report.plan.reference_samples, "{:.0f}"),
            number_(at + "reference RMSE", report.reference_rmse));
        show(image_figures(scene));
        const ImageCurve& first = report.curves.front();
        const auto is_first = [&](const ImageCurve& curve) {
            return curve.machine == first.machine && curve.traversal == first.traversal;
        };
        std::vector<Cells> rows;
        for (const ImageCurve& curve : report.curves) {
            const std::string name = fmt::format("{}, {}, {}", name_of(curve.sampler), curve.machine, curve.traversal);
            const std::string key = at + name;
            rows.push_back({name, number_(key + ": slope", curve.fit.slope, "{:.2f}"),
                            range(key + ": slope", curve.fit.interval.low, curve.fit.interval.high, "{:.2f}"),
                            number_(key + ": frame ms", curve.frame.median_ms),
                            range(key + ": frame ms", curve.frame.p25_ms, curve.frame.p75_ms, "{:.3g}"),
                            is_first(curve) ? "" : number_.ratio(key + ": frame / first", curve.of_first),
                            number_(key + ": frames", curve.frame.samples, "{:.0f}"),
                            number_(key + ": RMSE of most samples", curve.points.back().rmse),
                            number_(key + ": FLIP of most samples", curve.points.back().flip),
                            number_(key + ": largest gap", curve.worst_gap, "{:.1e}")});
        }
        html_ += html_table({"sampler, machine, traversal", "slope", "95 %", "frame ms", "middle half",
                             "of the first (95 %)", "frames", "last RMSE", "last FLIP", "largest gap to the first"},
                            rows);
        write_gaps(report, at);
        write_clocks(report, at);
        save_table(fmt::format("p1-{}.csv", scene.name.stem), image_csv(report));
        save_table(fmt::format("p1-{}-slopes.csv", scene.name.stem), slope_csv(report));
    }

    /// How far the traversals of a machine differ in what they make of the same samples.
    void write_gaps(const ImageReport& report, const std::string& at) {
        std::string gaps;
        for (const std::string& machine : report.machines())
            gaps += fmt::format("{}at most {} on {}", gaps.empty() ? "" : ", ",
                                number_(at + "largest gap on " + machine, report.own_gap(machine), "{:.1e}"), machine);
        html_ += fmt::format("<p>Traversals on one machine differ in RMSE by {}; up to {} is rounding: {}.</p>\n", gaps,
                             number_(at + "largest gap by rounding", ImageReport::most_own_gap, "{:.0e}"),
                             report.same_images() ? "none changes the image" : "a fault, for one changes the image");
    }

    /// How far two clocks disagree about the same frames, where there are two.
    void write_clocks(const ImageReport& report, const std::string& at) {
        double worst = 0;
        for (const ImageCurve& curve : report.curves)
            if (std::abs(curve.clock_discrepancy) > std::abs(worst)) worst = curve.clock_discrepancy;
        if (worst == 0) return;
        html_ +=
            fmt::format("<p>The GPU times its frames by queries of its own; the steady clock, over the same frames, "
                        "differs from that by up to {} %.</p>\n",
                        number_(at + "steady clock, percent", 100 * worst, "{:+.1f}"));
    }

    void write_p2(const HitReport& report) {
        html_ += fmt::format(
            "<h2>P2: hit error against time</h2>\n<p>Each diagram is one family of rays, {} of each at most, traced by "
            "two triangle tests, two sets of rules and three traversals in single and double precision: the share of "
            "rays that miss what is there or hit something else, and the error of t. The rules as published and the "
            "test of "
            "1997 lose rays where geometry meets; double precision moves that away and does not mend it. "
            "The scenes given play no part in it: rays and triangles are those of the stability suite.</p>\n",
            number_("P2: rays", double(report.rays), "{:.0f}"));
        show(hit_figures(report));
        for (const auto& [what, why] : left_out_hit_figures(report)) left_out(ErrorReport::p2, what, why);
        std::vector<Cells> rows;
        for (const HitRow& row : report.rows) {
            if (row.method.traversal != Traversal::stack) continue;
            const std::string name = row.family + ": " + row.method.family_name();
            const std::string key = "P2: " + name;
            const auto ulps = [&](const char* which, double value) {
                return value < 0 ? "–" : number_(key + ": ulp, " + which, value);
            };
            std::string faults = number_(key + ": per million", row.per_million(), "{:.0f}");
            if (row.missed + row.wrong == 0)
                faults += ", below " + number_(key + ": per million, 95 % bound", 1e6 * row.upper95, "{:.0f}");
            rows.push_back({name, faults, ulps("median", row.ulp_p50), ulps("99.9 %", row.ulp_p999),
                            ulps("largest", row.ulp_most), number_(key + ": ns per ray", row.ns, "{:.0f}"),
                            range(key + ": ns per ray", row.quartiles.low, row.quartiles.high, "{:.0f}"),
                            row.method == HitMethod{} ? "" : number_.ratio(key + ": time / first", row.of_first)});
        }
        html_ += "<details><summary>All methods with a stack, as numbers</summary>\n";
        html_ += html_table({"family, method", "faults per million", "ulp, median", "99.9 %", "largest", "ns per ray",
                             "middle half", "of the first (95 %)"},
                            rows);
        html_ += "</details>\n";
        save_table("p2.csv", hit_csv(report));
    }

    void write_p3() {
        html_ +=
            "<h2>P3: what the surface area heuristic predicts, and what is paid</h2>\n<p>For lines of which each is "
            "as likely as any other and that nothing stops, the predicted cost of a tree has to be the counted one: "
            "that checks the cost itself. Real rays start somewhere and end at surfaces, so they pay something else, "
            "mostly "
            "less, but better trees should still be better for them: that is what the rank correlation says.</p>\n";
        each_scene(ErrorReport::p3, [&](const SceneErrorTime& scene) {
            if (scene.trees) write_predictions(scene);
        });
    }

    void write_predictions(const SceneErrorTime& scene) {
        const TreeReport& report = *scene.trees;
        const std::string at = scene.name.shown + ": P3: ";
        show(prediction_figures(scene));
        Cells titles{"tree", "predicted", "lines: counted / predicted", "interior nodes", "triangle tests"};
        for (std::size_t pass = 0; pass < pass_count; ++pass)
            if (report.rays[pass] > 0) titles.push_back(fmt::format("{} ray", ray_names[pass]));
        titles.emplace_back("frame ms");
        std::vector<Cells> rows;
        for (const TreeRow& row : report.rows) {
            const std::string key = at + row.name();
            Cells cells{row.name(), number_(key + ": predicted", row.stats.sah_cost, "{:.2f}"),
                        number_(key + ": lines, counted / predicted", row.line_cost_ratio(), "{:.4f}"),
                        number_(key + ": lines, interior", row.line_interior_ratio(), "{:.4f}"),
                        number_(key + ": lines, tests", row.line_test_ratio(), "{:.4f}")};
            for (std::size_t pass = 0; pass < pass_count; ++pass)
                if (report.rays[pass] > 0)
                    cells.push_back(number_(fmt::format("{}: cost per {} ray", key, ray_names[pass]),
                                            row.cost_per_ray[pass], "{:.2f}"));
            cells.push_back(number_(key + ": frame ms", row.frame.median_ms));
            rows.push_back(std::move(cells));
        }
        Cells tau{"Kendall's tau with the prediction", "", "", "", ""};
        for (std::size_t pass = 0; pass < pass_count; ++pass)
            if (report.tau[pass])
                tau.push_back(
                    number_(fmt::format("{}tau of {} rays", at, ray_names[pass]), *report.tau[pass], "{:+.2f}"));
        tau.push_back(number_(at + "tau of the frame time", report.frame_tau, "{:+.2f}"));
        rows.push_back(tau);
        html_ += html_table(titles, rows);
        html_ +=
            fmt::format("<p>Over {} lines the prediction is off by at most {} %, be it of interior nodes, of triangle "
                        "tests or of their sum; the cost's code is held to {} %: {}.</p>\n",
                        number_(at + "lines", double(report.rows.front().lines.rays), "{:.0f}"),
                        number_(at + "largest error, percent", 100 * report.line_error(), "{:.2f}"),
                        number_(at + "largest error allowed, percent", 100 * TreeReport::most_line_error, "{:.0f}"),
                        report.lines_agree() ? "it counts rightly" : "it counts wrongly");
        save_table(fmt::format("p3-{}.csv", scene.name.stem), tree_csv(report));
    }

    void write_p4() {
        html_ +=
            "<h2>P4: build time against quality</h2>\n<p>A builder that looks harder for splits takes longer and makes "
            "trees whose frames are quicker. Whether that pays depends on how many frames are traced with the tree: "
            "from the break-even number on, the reference is the better choice. It follows from the median ratio of "
            "the "
            "frames' times, round by round.</p>\n";
        each_scene(ErrorReport::p4, [&](const SceneErrorTime& scene) {
            const bool told =
                std::ranges::any_of(scene.left_out, [](const LeftOut& l) { return l.report == ErrorReport::p4; });
            if (scene.trees && !told) write_builds(scene);
        });
    }

    void write_builds(const SceneErrorTime& scene) {
        const TreeReport& report = *scene.trees;
        const std::string at = scene.name.shown + ": P4: ";
        show(build_figures(scene));
        std::vector<Cells> rows;
        for (std::size_t i = 0; i < report.rows.size(); ++i) {
            const TreeRow& row = report.rows[i];
            const std::string key = at + row.name();
            const bool reference = i == report.reference;
            const std::string pays = row.break_even_frames
                                         ? number_(key + ": break-even frames", *row.break_even_frames, "{:.0f}")
                                     : reference ? "the reference"
                                                 : never_pays_text(row.frame_ratio);
            rows.push_back({row.name() + (row.cap_hit ? " (reference cap hit)" : ""),
                            number_(key + ": build ms", row.build.median_ms),
                            range(key + ": build ms", row.build.p25_ms, row.build.p75_ms, "{:.3g}"),
                            number_(key + ": SAH ratio", row.sah_ratio, "{:.3f}"),
                            number_(key + ": frame ms", row.frame.median_ms),
                            reference ? "" : number_.ratio(key + ": frame ratio", row.frame_ratio), pays});
        }
        html_ += html_table({"tree", "build ms", "middle half", "SAH / reference", "frame ms",
                             "frame / reference (95 %)", "reference pays from frame"},
                            rows);
        html_ +=
            fmt::format("<p>Frames of {} x {} pixels by the CPU.</p>\n", number_(at + "width", report.width, "{:.0f}"),
                        number_(at + "height", report.height, "{:.0f}"));
        save_table(fmt::format("p4-{}.csv", scene.name.stem), tree_csv(report));
    }

    std::filesystem::path folder_;
    const ErrorTimeResults& results_;
    std::vector<std::string> measured_on_;
    const std::stop_token& stop_;
    ShownNumbers number_;
    std::string left_out_csv_ = "report,what,why\n";
    std::string html_;
    std::vector<std::string> names_;
};

}  // namespace

std::vector<std::string> write_error_time(const std::filesystem::path& folder, const ErrorTimeResults& results,
                                          const std::stop_token& stop) {
    return Page(folder, results, stop).write();
}

}  // namespace kd
