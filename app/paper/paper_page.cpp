#include "app/paper/paper_page.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/cli/command.h"
#include "app/report/chart_files.h"
#include "app/report/html.h"
#include "renderer/io/file.h"
#include "renderer/io/png.h"

namespace kd {

namespace {

/// "not-reproduced": a class of the style sheet.
std::string style_class(std::string verdict) {
    std::ranges::replace(verdict, ' ', '-');
    return verdict;
}

std::string file_link(const std::string& name) { return fmt::format("<p><a href=\"{0}.csv\">{0}.csv</a></p>\n", name); }

/// The first `columns` of a table, with a link to the file that holds all of it.
std::string table_html(const PaperTable& table, std::size_t columns) {
    const auto shown = [columns](const std::vector<std::string>& cells) {
        std::vector<std::string> html;
        for (std::size_t i = 0; i < std::min(columns, cells.size()); ++i) html.push_back(html_text(cells[i]));
        return html;
    };
    std::vector<std::vector<std::string>> rows;
    for (const std::vector<std::string>& row : table.rows) rows.push_back(shown(row));
    return "<div class=\"scroll\">" + html_table(shown(table.header), rows) + "</div>\n" + file_link(table.name);
}

/// A row per claim: what it says and where, our number and what it is, what is accepted, the verdict and why.
std::string verdicts_html(const std::vector<PaperClaim>& claims) {
    std::string html =
        "<div class=\"scroll\"><table class=\"claims\">\n<tr><th></th><th>the paper says</th><th>our number, 95 % "
        "interval</th><th>accepted</th><th>verdict</th></tr>\n";
    for (const PaperClaim& c : claims) {
        const std::string verdict(name_of(c.verdict));
        html += fmt::format("<tr><td>{}</td><td>{}<small>{}</small></td><td>{}<small>{}</small></td><td>{}</td>"
                            "<td class=\"verdict {}\">{}<small>{}</small></td></tr>\n",
                            html_text(c.id), html_text(c.claim), html_text(c.where), html_text(interval_text(c.value)),
                            html_text(c.measure), c.measure == "–" ? "–" : c.accepted.text(), style_class(verdict),
                            verdict, html_text(c.reason));
    }
    return html + "</table></div>\n" + file_link("verdicts");
}

std::string pictures_html(const PaperResults& results) {
    std::string html = "<div class=\"pictures\">\n";
    for (const PaperPicture& picture : results.pictures)
        html += fmt::format(
            "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a><figcaption>{1}</figcaption></figure>\n",
            html_text(picture.file), html_text(picture.caption));
    return html + "</div>\n";
}

std::string heading(const std::string& text) { return fmt::format("<h2>{}</h2>\n", html_text(text)); }

std::string paragraph(const std::string& text) { return fmt::format("<p>{}</p>\n", html_text(text)); }

/// "5 reproduced, 4 not reproduced, 9 undecided".
std::string tally(const std::vector<PaperClaim>& claims) {
    std::string text;
    for (const PaperVerdict verdict : measured_verdicts)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                            std::ranges::count(claims, verdict, &PaperClaim::verdict), name_of(verdict));
    return text;
}

std::string head_of(const PaperResults& results, const std::vector<PaperClaim>& claims) {
    std::string html =
        fmt::format("<h1>The paper again</h1>\n<p class=\"lead\">Ikrima Elhassan, “An Analysis of GPU-based "
                    "Interactive Raytracing”: "
                    "its experiments, made again by kdscope {} ({}). {}.</p>\n",
                    html_text(results.on.version), html_text(results.on.commit), html_text(tally(claims)));
    if (results.on.software_gl)
        html +=
            paragraph("OpenGL is a program here: the shaders ran on the CPU. What the paper claims of a GPU against a "
                      "CPU is told with its number and left undecided.");
    if (!results.has_gpu_times()) html += paragraph("There was no OpenGL here, so GPURT is missing.");
    return html;
}

}  // namespace

std::string paper_page(const PaperResults& results, const std::vector<PaperClaim>& claims,
                       const std::vector<PaperFigure>& figures, bool drawn) {
    std::string html = head_of(results, claims);
    html += heading("Verdicts");
    html +=
        paragraph("A claim is reproduced where the whole interval of our number is accepted, not reproduced where none "
                  "of it is, and undecided otherwise. Where the paper prints a factor, what lies nearer to it than to "
                  "half or twice of it is accepted.");
    html += verdicts_html(claims);
    html += heading("Figures");
    if (!drawn) html += paragraph(no_gnuplot_text);
    for (const PaperFigure& figure : figures) html += html_chart(figure.name, figure.chart.title, figure.shows, drawn);
    if (!results.pictures.empty()) {
        html += heading("Unfinished pixels");
        html += paragraph("How each primary ray ended under a ceiling of steps: orange was given up, blue hit "
                          "something, dark nothing.");
        html += pictures_html(results);
        html += table_html(budget_table(results), 6);
    }
    html += heading("Times") + table_html(time_table(results), 13);
    html += heading("Counts") + table_html(count_table(results), 99);
    html += heading("Nodes of 16 and 8 bytes");
    html += paragraph("The same walk over the same tree: hits and counters are equal in every bit. The time of a frame "
                      "with nodes of the paper's size over that with nodes of half of it.");
    html += table_html(node_size_table(results), 99);
    html += heading("How this was measured");
    html +=
        paragraph("Every tracer of every scene runs once to warm up, then all of them in turn, in one order and the "
                  "reverse of it by turns. Ratios are taken round by round; their interval is the sign test's for the "
                  "median. Compiling, uploading and building are not in the times. The CPU tracers have as many "
                  "threads as the table says; the paper's processor had one.");
    html += table_html(run_table(results, claims), 2);
    return html_page("The paper again", html);
}

void write_paper(const std::filesystem::path& folder, const PaperResults& results, const FileDone& file_done,
                 const std::stop_token& stop) {
    const std::vector<std::string> comments = results.on.lines();
    const std::vector<PaperClaim> claims = judge_claims(results);
    const std::vector<PaperFigure> figures = paper_figures(results);
    const auto begin = [&](const std::string& name) {
        if (stop.stop_requested()) throw Interrupted();
        file_done(name);
    };
    for (const PaperTable& table : {verdict_table(claims), time_table(results), count_table(results),
                                    budget_table(results), node_size_table(results), run_table(results, claims)}) {
        begin(table.name + ".csv");
        write_file(folder / (table.name + ".csv"), table_csv(table, comments));
    }
    for (const PaperFigure& figure : figures) {
        begin(figure.name);
        (void)write_chart(folder, figure.name, figure.chart, comments, stop);
    }
    for (const PaperPicture& picture : results.pictures) {
        begin(picture.file);
        write_png(folder / picture.file, *picture.image);
    }
    begin("results.json");
    write_file(folder / "results.json", json_text(paper_json(results, claims)));
    begin("index.html");
    write_file(folder / "index.html", paper_page(results, claims, figures, can_draw_charts()));
}

}  // namespace kd
