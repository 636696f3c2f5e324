// P4: build time against the quality of trees.
#include <algorithm>
#include <fmt/format.h>

#include "app/error_time/page_reports.h"
#include "app/report/html.h"

namespace kd {

namespace {

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

void write_builds(ReportWriter& page, const SceneErrorTime& scene) {
    const TreeReport& report = *scene.trees;
    const std::string at = scene.name.shown + ": P4: ";
    page.show(build_figures(scene));
    std::vector<Cells> rows;
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const TreeRow& row = report.rows[i];
        const std::string key = at + row.name();
        const bool reference = i == report.reference;
        const std::string pays = row.break_even_frames
                                     ? page.with_range(key + ": break-even frames", *row.break_even_frames,
                                                       row.break_even_interval, "{:.0f}")
                                 : reference ? "the reference"
                                             : never_pays_text(row.frame_ratio);
        rows.push_back({row.name() + (row.cap_hit ? " (reference cap hit)" : ""),
                        page.number(key + ": build ms", row.build.median_ms),
                        page.range(key + ": build ms", row.build.p25_ms, row.build.p75_ms, "{:.3g}"),
                        page.number(key + ": SAH ratio", row.sah_ratio, "{:.3f}"),
                        page.number(key + ": frame ms", row.frame.median_ms),
                        reference ? "" : page.number.ratio(key + ": frame ratio", row.frame_ratio), pays});
    }
    page.html += html_table({"tree", "build ms", "middle half", "SAH / reference", "frame ms",
                             "frame / reference (95 %)", "reference pays from frame"},
                            rows);
    page.html +=
        fmt::format("<p>Frames of {} x {} pixels by the CPU.</p>\n", page.number(at + "width", report.width, "{:.0f}"),
                    page.number(at + "height", report.height, "{:.0f}"));
    page.save_table(fmt::format("p4-{}.csv", scene.name.stem), tree_csv(report));
}

}  // namespace

void write_p4(ReportWriter& page) {
    page.html +=
        "<h2>P4: build time against quality</h2>\n<p>A builder that looks harder for splits takes longer and makes "
        "trees whose frames are quicker. Whether that pays depends on how many frames are traced with the tree: "
        "from the break-even number on, the reference is the better choice. It follows from the median ratio of the "
        "frames' times, round by round; in brackets stand 95 % over rounds drawn with replacement.</p>\n";
    page.each_scene(ErrorReport::p4, [&](const SceneErrorTime& scene) {
        const bool told =
            std::ranges::any_of(scene.left_out, [](const LeftOut& l) { return l.report == ErrorReport::p4; });
        if (scene.trees && !told) write_builds(page, scene);
    });
}

}  // namespace kd
