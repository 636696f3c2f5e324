// What scenes are called in reports: no two alike, on the page or as files.
#pragma once

#include <string>
#include <vector>

namespace kd {

struct ReportName {
    std::string shown;  // "ball:9000"; a scene that is given twice has " (2)" behind it
    std::string stem;   // of its files: "ball-9000"
};

/// A name for each scene as it was asked for. The files that one scene's reports make of their stem are never those of
/// another scene, also where letters are taken for the same in both cases.
[[nodiscard]] std::vector<ReportName> report_names(const std::vector<std::string>& scenes);

}  // namespace kd
