// The engine's queue of one, its way back, and its frames: from many threads at once.
#include "app/engine/worker.h"

#include <atomic>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "app/engine/frame_pool.h"
#include "app/engine/mailbox.h"

namespace kd {
namespace {

void wait_until_idle(const Worker& worker) {
    while (worker.busy()) std::this_thread::yield();
}

TEST(Worker, TheNewestOfManyJobsRunsAndTheRunningOneIsStopped) {
    std::atomic<int> last = -1, running = 0;
    Worker worker;
    for (int i = 0; i < 2000; ++i)
        worker.submit([&, i](const std::stop_token& stop) {
            EXPECT_EQ(++running, 1) << "one at a time";
            while (i % 7 == 0 && i != 1999 && !stop.stop_requested()) std::this_thread::yield();
            last = i;
            --running;
        });
    wait_until_idle(worker);
    EXPECT_EQ(last, 1999);
}

TEST(Worker, ACancelledJobDoesNotRunAndTheOneAfterItDoes) {
    std::mt19937 random(1);
    std::atomic<int> last = -1;
    Worker worker(Worker::Priority::low);
    for (int i = 0; i < 1000; ++i) {
        worker.submit([&, i](const std::stop_token&) { last = i; });
        if (random() % 3 == 0) worker.cancel();
    }
    worker.submit([&](const std::stop_token&) { last = 1000; });
    wait_until_idle(worker);
    EXPECT_EQ(last, 1000);
}

TEST(Worker, ItsEndStopsTheRunningJobAndRunsTheExitOnItsThread) {
    std::thread::id of_job, of_exit;
    {
        std::atomic<bool> began = false;
        Worker worker(Worker::Priority::normal, [&] { of_exit = std::this_thread::get_id(); });
        worker.submit([&](const std::stop_token& stop) {
            of_job = std::this_thread::get_id();
            began = true;
            while (!stop.stop_requested()) std::this_thread::yield();
        });
        while (!began) std::this_thread::yield();
    }
    EXPECT_EQ(of_job, of_exit);
    EXPECT_NE(of_job, std::this_thread::get_id());
}

TEST(Mailbox, LosesNothingAndKeepsTheOrderOfEachPoster) {
    constexpr int posters = 4, letters = 2000;
    std::atomic<int> woken = 0;
    Mailbox mailbox([&] { ++woken; });
    std::vector<std::vector<int>> got(posters);
    std::vector<std::jthread> threads;
    for (int p = 0; p < posters; ++p)
        threads.emplace_back([&, p] {
            for (int i = 0; i < letters; ++i) mailbox.post([&got, p, i] { got[std::size_t(p)].push_back(i); });
        });
    std::size_t arrived = 0;
    while (arrived < std::size_t(posters) * letters) {
        if (mailbox.wait(0.1)) mailbox.deliver();
        arrived = 0;
        for (const auto& list : got) arrived += list.size();
    }
    threads.clear();
    EXPECT_EQ(woken, posters * letters);
    EXPECT_FALSE(mailbox.deliver());
    for (const auto& list : got)
        for (int i = 0; i < letters; ++i) ASSERT_EQ(list[std::size_t(i)], i);
}

TEST(FramePool, FramesComeBackFromAnyThread) {
    FramePool pool;
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&pool, t] {
            for (int i = 0; i < 20; ++i) {
                const std::shared_ptr<Frame> frame = pool.take(256 + t % 2, 256);
                ASSERT_EQ(frame->width, 256 + t % 2);
                frame->colour.at(3, 3).x = float(t);
            }
        });
}

}  // namespace
}  // namespace kd
