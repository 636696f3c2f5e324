// Rounds of CPU against GPU are kept for each frame: what leaves the frame alone does not throw them away.
#include "app/engine/duel_book.h"

#include <gtest/gtest.h>

namespace kd {
namespace {

DuelReply reply_of(double cpu_ms, int scale = 1) {
    DuelReply reply;
    reply.round.cpu.ms = cpu_ms;
    reply.round.gl.ms = 2 * cpu_ms;
    reply.width = 64 / scale;
    reply.height = 48 / scale;
    reply.scale = scale;
    return reply;
}

Session session_by(Traversal traversal) {
    Session session;
    session.trace.traversal = traversal;
    return session;
}

struct DuelBookTest : testing::Test {
    DuelState shown;
    DuelBook book{shown};
    const Session a = session_by(Traversal::stack), b = session_by(Traversal::restart);

    void add(std::initializer_list<double> cpu_ms, int scale = 1) {
        for (const double ms : cpu_ms) book.add(reply_of(ms, scale));
    }
};

TEST_F(DuelBookTest, TheFirstRoundWarmsUp) {
    book.turn_to(a);
    EXPECT_TRUE(shown.outdated);
    add({90});
    EXPECT_TRUE(shown.rounds.empty());
    add({10, 12, 11});
    EXPECT_FALSE(shown.outdated);
    EXPECT_EQ(shown.rounds.size(), 3u);
    EXPECT_DOUBLE_EQ(shown.cpu.median_ms, 11);
}

TEST_F(DuelBookTest, TheOtherMachineAndAnotherMapLeaveTheFrameAlone) {
    book.turn_to(a);
    add({90, 10, 12});
    Session other = a;
    other.tracer = TracerKind::gl_fragment;
    other.view.show_map = !other.view.show_map;
    other.view.overlay.show = !other.view.overlay.show;
    book.turn_to(other);
    EXPECT_FALSE(shown.outdated);
    add({11});
    EXPECT_EQ(shown.rounds.size(), 3u) << "no new warm-up either";
}

TEST_F(DuelBookTest, AnotherSettingHasRoundsOfItsOwnAndTheWayBackFindsThoseOfBefore) {
    book.turn_to(a);
    add({90, 10, 12});
    book.turn_to(b);
    EXPECT_TRUE(shown.outdated);
    EXPECT_EQ(shown.traversal, Traversal::stack) << "shown dim until there are others";
    add({90, 30});
    EXPECT_FALSE(shown.outdated);
    EXPECT_EQ(shown.traversal, Traversal::restart);
    EXPECT_DOUBLE_EQ(shown.cpu.median_ms, 30);
    book.turn_to(a);
    EXPECT_FALSE(shown.outdated);
    EXPECT_EQ(shown.traversal, Traversal::stack);
    EXPECT_EQ(shown.rounds.size(), 2u);
    add({90, 11});
    EXPECT_EQ(shown.rounds.size(), 3u) << "the first after the way back warms up";
    EXPECT_DOUBLE_EQ(shown.cpu.median_ms, 11);
}

TEST_F(DuelBookTest, RoundsOfAnotherSizeBeginAnew) {
    book.turn_to(a);
    add({90, 10, 12});
    add({3}, 2);
    EXPECT_TRUE(shown.outdated);
    add({4}, 2);
    EXPECT_FALSE(shown.outdated);
    EXPECT_EQ(shown.rounds.size(), 1u);
    EXPECT_EQ(shown.width, 32);
}

TEST_F(DuelBookTest, ASizeThatAPersonChoseHasItsOwn) {
    book.turn_to(a);
    add({90, 10, 12});
    book.turn_to(a, 2);
    EXPECT_TRUE(shown.outdated);
    add({90, 3}, 2);
    EXPECT_TRUE(shown.chosen);
    EXPECT_EQ(shown.width, 32);
    book.turn_to(a);
    EXPECT_FALSE(shown.outdated);
    EXPECT_FALSE(shown.chosen);
    EXPECT_EQ(shown.width, 64);
}

TEST_F(DuelBookTest, ForgetsAllWhenAskedTo) {
    book.turn_to(a);
    add({90, 10});
    book.turn_to(b);
    book.forget();
    book.turn_to(a);
    EXPECT_TRUE(shown.outdated);
}

TEST_F(DuelBookTest, KeepsThoseOfAFewFrames) {
    Session session = a;
    for (int i = 1; i <= 20; ++i) {
        session.trace.step_budget = i;
        book.turn_to(session);
        add({90, 10});
    }
    book.turn_to(session);
    EXPECT_FALSE(shown.outdated);
    session.trace.step_budget = 15;
    book.turn_to(session);
    EXPECT_FALSE(shown.outdated);
    session.trace.step_budget = 1;
    book.turn_to(session);
    EXPECT_TRUE(shown.outdated);
}

}  // namespace
}  // namespace kd
