// Frames by OpenGL that are timed: a GPU that has idled is woken first.
#include "app/frame/gl_frame.h"

#include <gtest/gtest.h>
#include <thread>

#include "renderer/kdtree/build.h"
#include "tests/support/scenes.h"

namespace kd {
namespace {

TEST(GlFrameDrawer, WakesAfterAPauseUnlessStopped) {
    std::unique_ptr<Context> context;
    try {
        context = Context::create(ContextKind::automatic);
    } catch (const ContextError& error) {
        GTEST_SKIP() << "NO CONTEXT: " << error.what();
    }
    const FlatScene scene = test::mirror_scene(20, 1);
    const KdTree tree = build_tree(scene.triangles, {});
    GlTracer tracer(*context);
    tracer.upload(scene, tree);
    const PinholeCamera camera = pinhole(scene.camera, 8, 8);
    GlFrameDrawer drawer(100);
    std::stop_source stop;
    const auto wake = [&] { return drawer.wake(tracer, {}, camera, 8, 8, stop.get_token()); };

    tracer.prepare({}, 8, 8);
    EXPECT_GE(wake(), 1) << "nothing was drawn before";
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_GE(wake(), 1) << "a pause";
    stop.request_stop();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(wake(), 0) << "stopped";
}

}  // namespace
}  // namespace kd
