// How lanes in lockstep share their iterations: the names alone, for whoever chooses one.
#pragma once

#include <span>
#include <string_view>

namespace kd {

/// How lanes whose next steps are of different kinds share their iterations.
///
/// lockstep:    every lane makes its next step, whatever it is; rays of a pixel follow each other without waiting.
/// if_if:       one loop; an iteration makes every lane's next step, first the interior ones, then those at leaves, and
///              costs one for each of the two kinds that is there.
/// while_while: two loops inside of one; interior steps until no lane has one next, then leaf visits and triangle tests
/// until
///              none has one next.
/// The last two begin each round of rays together, as a shader does.
enum class Schedule { lockstep, if_if, while_while };
inline constexpr int schedule_count = 3;

struct ScheduleInfo {
    Schedule id;
    std::string_view name;  // on the command line: "while-while"
    std::string_view summary;
};
[[nodiscard]] std::span<const ScheduleInfo> schedules();
[[nodiscard]] const ScheduleInfo& info(Schedule schedule);

}  // namespace kd
