// The page of `kdscope paper`, and the folder that it stands in.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/paper/paper_charts.h"
#include "app/paper/paper_tables.h"

namespace kd {

/// One file of HTML with relative links to the figures (SVG where `drawn`, else their tables) and pictures beside it;
/// no script, nothing from elsewhere.
[[nodiscard]] std::string paper_page(const PaperResults& results, const std::vector<PaperClaim>& claims,
                                     const std::vector<PaperFigure>& figures, bool drawn);

/// Told of each file before it is written.
using FileDone = std::function<void(const std::string& name)>;

/// Writes tables, figures, pictures, results.json and last index.html; each whole or not at all. InputError,
/// Interrupted.
void write_paper(const std::filesystem::path& folder, const PaperResults& results, const FileDone& file_done,
                 const std::stop_token& stop);

}  // namespace kd
