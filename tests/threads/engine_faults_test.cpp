// F14 and F15 of docs/stability.md: scenes changed faster than they are built, and memory that runs out.
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <random>

#include "tests/app/engine_run.h"
#include "tests/threads/scarce_memory.h"

namespace kd {
namespace {

using namespace std::chrono_literals;
using test::ScarceMemory;

bool says_memory(const EngineState& state) {
    for (const Message& message : state.messages)
        if (message.error && message.text.find("not enough memory") != std::string::npos) return true;
    return false;
}

TEST(EngineFaults, F14_AThousandRandomSwitchesEndWithTheLastAndKeepNothingElse) {
    const std::string scenes[] = {"ball:200", "ball:900", "rooms", "scatter:700", "cornell", "no-such-scene.gltf"};
    std::mt19937 random(7);
    Engine engine(small_session("ball:200"), {.open_gl = {}, .wake = {}, .duel = true});
    std::map<const World*, std::weak_ptr<const World>> worlds;
    Session session = small_session("ball:200");
    session.threads = 2;
    for (int i = 0; i < 1000; ++i) {
        session.scene = scenes[random() % std::size(scenes)];
        session.build.leaf_size = 1 + int(random() % 8);
        session.trace.traversal = random() % 2 ? Traversal::restart : Traversal::stack;
        session.width = 32 + int(random() % 32);
        session.seed = unsigned(1 + random() % 3);
        engine.set_session(session);
        if (random() % 4 == 0) engine.cancel_build();
        if (random() % 8 == 0) engine.note_input();
        engine.set_probes(PixelPosition{int(random() % 64), 3}, std::nullopt);
        if (random() % 16 == 0) std::this_thread::sleep_for(2ms);
        engine.poll();
        if (const auto& world = engine.state().world) worlds.emplace(world.get(), world);
    }
    session = small_session("rooms");
    session.build.leaf_size = 5;
    engine.set_session(session);
    engine.allow_duel(false);
    ASSERT_TRUE(wait_until(engine, [](const EngineState& s) {
        return !s.stale() && !s.working() && s.world->loaded->name == "rooms" && s.world->built_with.leaf_size == 5;
    }));
    EXPECT_EQ(engine.state().session.scene, "rooms");
    EXPECT_EQ(engine.state().picture->traced.world, engine.state().world);

    // A picture of another size replaces what the machines still hold; then nothing keeps an older tree.
    session.width = 65;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    const auto kept = [&worlds](const EngineState& state) {
        return std::ranges::count_if(worlds, [&](const auto& world) {
            const auto alive = world.second.lock();
            return alive && alive != state.world;
        });
    };
    // A thread may still be letting go of its last job.
    EXPECT_TRUE(wait_until(engine, [&](const EngineState& s) { return kept(s) == 0; }))
        << kept(engine.state()) << " of " << worlds.size() << " trees";
}

TEST(EngineFaults, F15_MemoryThatRunsOutInLoadingKeepsTheOldScene) {
    Engine engine(small_session("ball:300"), {.open_gl = {}, .wake = {}, .duel = false});
    ASSERT_TRUE(settle(engine));
    const auto before = engine.state().picture;
    {
        const ScarceMemory scarce(1 << 20);
        engine.set_session(small_session("scatter:60000"));
        ASSERT_TRUE(wait_until(engine, says_memory));
        ASSERT_TRUE(settle(engine));
    }
    EXPECT_EQ(engine.state().session.scene, "ball:300");
    EXPECT_EQ(engine.state().picture->image, before->image);
    engine.set_session(small_session("scatter:60000"));
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().world->loaded->name, "scatter:60000") << "with memory it goes";
}

TEST(EngineFaults, F15_MemoryThatRunsOutInABuildKeepsTheOldTree) {
    Engine engine(small_session("scatter:60000"), {.open_gl = {}, .wake = {}, .duel = false});
    ASSERT_TRUE(settle(engine));
    const auto world = engine.state().world;
    Session session = engine.state().session;
    session.build.leaf_size += 3;
    {
        const ScarceMemory scarce(1 << 18);
        engine.set_session(session);
        ASSERT_TRUE(wait_until(engine, says_memory));
        ASSERT_TRUE(settle(engine));
    }
    EXPECT_EQ(engine.state().world, world);
    EXPECT_EQ(engine.state().session.build, world->built_with);
}

TEST(EngineFaults, F15_MemoryThatRunsOutForAPictureKeepsTheOldOne) {
    Engine engine(small_session("ball:300"), {.open_gl = {}, .wake = {}, .duel = false});
    ASSERT_TRUE(settle(engine));
    const auto before = engine.state().picture;
    Session session = engine.state().session;
    session.width = session.height = 600;
    {
        const ScarceMemory scarce(1 << 20);
        engine.set_session(session);
        ASSERT_TRUE(wait_until(engine, says_memory));
        ASSERT_TRUE(wait_until(engine, [](const EngineState& s) { return !s.working(); }));
    }
    ASSERT_TRUE(engine.state().picture);
    const TracedFrame& shown = engine.state().picture->traced;
    EXPECT_TRUE(shown.frame == before->traced.frame || shown.scale > 1) << "the old picture, or a preview that fitted";
    EXPECT_EQ(shown.frame->colour.pixels.size(), std::size_t(shown.frame->width) * std::size_t(shown.frame->height));
    session.width = 50;
    engine.set_session(session);
    ASSERT_TRUE(settle(engine));
    EXPECT_EQ(engine.state().picture->image.width, 50) << "and goes on";
}

}  // namespace
}  // namespace kd
