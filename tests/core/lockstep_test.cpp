// Groups in lockstep, by hand: what each schedule makes of lists of steps that are known.

#include "renderer/trace/lockstep.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace kd {
namespace {

/// "IILTT": two interior nodes, a leaf, two triangles. Nodes are 0, 10, 20, ... unless `nodes` says which.
Walk walk_of(const std::string& steps, std::vector<std::uint32_t> nodes = {}) {
    Walk walk;
    std::size_t node = 0;
    std::uint32_t slot = 0;
    for (const char step : steps) {
        if (step == 'T') {
            walk.add(StepKind::triangle, slot++);
            continue;
        }
        const std::uint32_t at = node < nodes.size() ? nodes[node] : std::uint32_t(10 * node);
        walk.add(step == 'I' ? StepKind::interior : StepKind::leaf, at);
        ++node;
    }
    return walk;
}

PixelWalks pixel_of(const std::vector<Walk>& walks, int first_round = 0) {
    PixelWalks pixel;
    for (const Walk& walk : walks) pixel.rays.push_back({first_round++, walk});
    return pixel;
}

struct Group {
    std::vector<PixelWalks> pixels;
    explicit Group(std::vector<PixelWalks> all) : pixels(std::move(all)) {}
    [[nodiscard]] std::vector<const PixelWalks*> lanes() const {
        std::vector<const PixelWalks*> result;
        for (const PixelWalks& pixel : pixels) result.push_back(&pixel);
        return result;
    }
    [[nodiscard]] GroupTally run(Schedule schedule) const { return run_group(lanes(), schedule); }
    [[nodiscard]] NodeReads reads(Schedule schedule) const { return read_nodes(lanes(), schedule, 16); }
};

TEST(Walk, JoinsNeighbouringAddresses) {
    Walk walk = walk_of("IIL", {0, 1, 2});
    ASSERT_EQ(walk.runs().size(), 2u);
    EXPECT_EQ(walk.runs()[0], (StepRun{0, 2, StepKind::interior}));
    EXPECT_EQ(walk.runs()[1], (StepRun{2, 1, StepKind::leaf}));
    EXPECT_EQ(walk_of("II", {0, 2}).runs().size(), 2u);
    walk.append(walk_of("ITT"));
    EXPECT_EQ(walk.steps(), 6u);
    EXPECT_EQ(walk.interior_steps(), 3u);
}

TEST(Walk, PhasesBeginWithInteriorOnes) {
    EXPECT_EQ(walk_of("IILTTLI").phases(), (std::vector<std::uint32_t>{2, 4, 1}));
    EXPECT_EQ(walk_of("LT").phases(), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_TRUE(walk_of("").phases().empty());
}

TEST(Lockstep, ALeafFirstLaneAndADeepOne) {
    // lane 0: L T     lane 1: I I I L
    const Group group({pixel_of({walk_of("LT")}), pixel_of({walk_of("IIIL")})});
    EXPECT_EQ(group.run(Schedule::lockstep), (GroupTally{6, 4, 0}));
    // Iterations 0 and 1 hold both kinds, 2 an interior step, 3 a leaf: 2 + 2 + 1 + 1.
    EXPECT_EQ(group.run(Schedule::if_if), (GroupTally{6, 6, 3}));
    // Three interior iterations, for lane 1 alone; then two at leaves.
    EXPECT_EQ(group.run(Schedule::while_while), (GroupTally{6, 5, 3}));
}

TEST(Lockstep, LeavesInARowStayInOnePhase) {
    const Group group({pixel_of({walk_of("ILTLTT")}), pixel_of({walk_of("ILTIL")})});
    EXPECT_EQ(group.run(Schedule::lockstep), (GroupTally{11, 6, 0}));
    EXPECT_EQ(group.run(Schedule::while_while), (GroupTally{11, 1 + 5 + 1 + 1, 2}));
    // I|I, L|L, T|T, L|I, T|L, T|-: the fourth holds both kinds.
    EXPECT_EQ(group.run(Schedule::if_if), (GroupTally{11, 7, 2}));
}

TEST(Lockstep, RoundsWaitForEachOtherButNotInTheIdealisedSchedule) {
    // Two lights: the first lane has a ray for the second one only, the second lane for both.
    const Group group({pixel_of({walk_of("II")}, 1), pixel_of({walk_of("IIII"), walk_of("I")})});
    EXPECT_EQ(group.run(Schedule::lockstep), (GroupTally{7, 5, 0}));
    EXPECT_EQ(group.run(Schedule::while_while), (GroupTally{7, 4 + 2, 6}));
    EXPECT_EQ(group.run(Schedule::if_if), (GroupTally{7, 4 + 2, 6}));
}

TEST(Lockstep, EqualWalksLoseNothing) {
    const PixelWalks pixel = pixel_of({walk_of("IILTTILTI"), walk_of("LLT")});
    const Group group({pixel, pixel, pixel, pixel});
    for (const ScheduleInfo& schedule : schedules()) {
        EXPECT_EQ(group.run(schedule.id).efficiency(4), 1.0) << schedule.name;
        EXPECT_EQ(group.reads(schedule.id).coherence(), 1.0) << schedule.name;
    }
}

TEST(Lockstep, ALaneAloneNeverWaits) {
    const Group group({pixel_of({walk_of("IILTTILTI"), walk_of("ITT")})});
    for (const ScheduleInfo& schedule : schedules()) {
        EXPECT_EQ(group.run(schedule.id), (GroupTally{12, 12, schedule.id == Schedule::lockstep ? 0u : 5u}));
        EXPECT_EQ(group.run(schedule.id).efficiency(1), 1.0);
        EXPECT_TRUE(std::isnan(group.reads(schedule.id).coherence())) << "nobody to read with";
    }
}

TEST(Lockstep, AGroupWithoutRaysHasNoEfficiency) {
    const std::vector<const PixelWalks*> lanes{nullptr, nullptr};
    for (const ScheduleInfo& schedule : schedules())
        EXPECT_TRUE(std::isnan(run_group(lanes, schedule.id).efficiency(2)));
}

TEST(NodeReads, CountsNodesSectorsAndLines) {
    // Iteration 0: node 0 by both. 1: nodes 2 and 3, one sector. 2: 4 and 9, two lines. 3: a leaf and a triangle, one
    // read.
    const Group group({pixel_of({walk_of("IIILT", {0, 2, 4, 20})}), pixel_of({walk_of("IIILTT", {0, 3, 9, 20})})});
    for (const Schedule schedule : {Schedule::lockstep, Schedule::while_while}) {
        const NodeReads reads = group.reads(schedule);
        EXPECT_EQ(reads, (NodeReads{4, 8, 1 + 2 + 2 + 1, 1 + 1 + 2 + 1, 1 + 1 + 2 + 1})) << info(schedule).name;
        EXPECT_EQ(reads.coherence(), 2.0 / 4);
    }
}

TEST(NodeReads, TwiceAsManyNodesOf8BytesLieInOneSector) {
    // As above; nodes 4 and 9 are in two sectors of one line.
    const Group group({pixel_of({walk_of("IIILT", {0, 2, 4, 20})}), pixel_of({walk_of("IIILTT", {0, 3, 9, 20})})});
    EXPECT_EQ(read_nodes(group.lanes(), Schedule::lockstep, 8),
              (NodeReads{4, 8, 1 + 2 + 2 + 1, 1 + 1 + 2 + 1, 1 + 1 + 1 + 1}));
}

TEST(NodeReads, KindsReadApartUnderIfIf) {
    // The second step is a leaf for one lane and an interior node for the other.
    const Group group({pixel_of({walk_of("IL", {0, 1})}), pixel_of({walk_of("II", {0, 1})})});
    EXPECT_EQ(group.reads(Schedule::lockstep), (NodeReads{2, 4, 2, 2, 2}));
    EXPECT_EQ(group.reads(Schedule::if_if), (NodeReads{3, 4, 3, 3, 3}));
    EXPECT_EQ(group.reads(Schedule::while_while), (NodeReads{3, 4, 3, 3, 3}));
}

}  // namespace
}  // namespace kd
