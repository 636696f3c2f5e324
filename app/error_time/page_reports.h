// The page's part on each report: two sentences, the diagrams and the numbers that matter.
#pragma once

#include "app/error_time/report_writer.h"

namespace kd {

void write_p1(ReportWriter& page);
void write_p2(ReportWriter& page, const HitReport& report);
void write_p3(ReportWriter& page);
void write_p4(ReportWriter& page);
void write_p5(ReportWriter& page);
void write_p6(ReportWriter& page);

}  // namespace kd
