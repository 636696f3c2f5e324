#include "renderer/trace/schedule.h"

#include <array>

namespace kd {

namespace {

constexpr std::array<ScheduleInfo, schedule_count> table{{
    {Schedule::lockstep, "lockstep",
     "Every lane makes its next step, whatever kind it is: the least that any lockstep costs."},
    {Schedule::if_if, "if-if", "One loop: in each iteration the lanes at interior nodes step, then those at leaves."},
    {Schedule::while_while, "while-while",
     "Two loops in one: all lanes go down until each is at a leaf, then all test until none is."},
}};

}  // namespace

std::span<const ScheduleInfo> schedules() { return table; }

const ScheduleInfo& info(Schedule schedule) { return table[static_cast<std::size_t>(schedule)]; }

}  // namespace kd
