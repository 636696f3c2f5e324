// The thread helper, whichever of its two forms this build has.
#include <atomic>
#include <gtest/gtest.h>
#include <stdexcept>
#include <vector>

#include "renderer/cpu/threads.h"

namespace kd {
namespace {

TEST(ParallelRanges, CoverEveryNumberOnceInRangesOfTheGrain) {
    for (const std::size_t count : {0u, 1u, 7u, 64u, 1000u})
        for (const std::size_t grain : {1u, 3u, 64u, 5000u})
            for (const int threads : {0, 1, 2, 7}) {
                std::vector<std::atomic<int>> seen(count);
                parallel_ranges(count, grain, threads, [&](std::size_t first, std::size_t last) {
                    EXPECT_LT(first, last);
                    EXPECT_LE(last, count);
                    EXPECT_LE(last - first, grain);
                    for (std::size_t i = first; i < last; ++i) ++seen[i];
                });
                for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(seen[i], 1) << i << " of " << count;
            }
}

TEST(ParallelRanges, WhatTheyWroteIsThereAfterwards) {
    std::vector<std::size_t> squares(10'000);
    for (int round = 0; round < 20; ++round) {
        parallel_ranges(squares.size(), 16, 4, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) squares[i] += i * i;
        });
    }
    for (std::size_t i = 0; i < squares.size(); ++i) ASSERT_EQ(squares[i], 20 * i * i);
}

TEST(ParallelRanges, AnExceptionComesOutAndTheNextLoopRuns) {
    for (const int threads : {1, 2, 7}) {
        const auto throwing = [](std::size_t first, std::size_t) {
            if (first % 10 == 3) throw std::runtime_error("three");
        };
        EXPECT_THROW(parallel_ranges(1000, 1, threads, throwing), std::runtime_error);
        std::atomic<int> ran = 0;
        parallel_ranges(100, 1, threads, [&](std::size_t, std::size_t) { ++ran; });
        EXPECT_EQ(ran, 100);
    }
}

TEST(ParallelRanges, MayBeNested) {
    std::atomic<int> ran = 0;
    parallel_ranges(
        4, 1, 2, [&](std::size_t, std::size_t) { parallel_ranges(5, 1, 2, [&](std::size_t, std::size_t) { ++ran; }); });
    EXPECT_EQ(ran, 20);
}

}  // namespace
}  // namespace kd
