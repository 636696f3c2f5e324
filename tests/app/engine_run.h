// Running the engine inside of a test.
#pragma once

#include <chrono>
#include <gtest/gtest.h>
#include <string>
#include <thread>

#include "app/engine/engine.h"
#include "tests/support/patience.h"

namespace kd {

inline Session small_session(const std::string& scene = "ball:300") {
    Session session;
    session.scene = scene;
    session.width = 64;
    session.height = 48;
    session.threads = 1;
    return session;
}

inline EngineOptions quiet() {
    EngineOptions options;
    options.duel = false;
    return options;
}

/// Polls until `done` holds; false where patience ends.
template <class Done>
bool wait_until(Engine& engine, const Done& done, std::chrono::seconds patience = test::patience()) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
        engine.poll();
        if (done(engine.state())) return true;
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

inline bool settle(Engine& engine, std::chrono::seconds patience = test::patience()) {
    return wait_until(
        engine, [](const EngineState& s) { return !s.stale() && !s.working(); }, patience);
}

inline bool has_error(const EngineState& state, const std::string& part) {
    for (const Message& message : state.messages)
        if (message.error && message.text.find(part) != std::string::npos) return true;
    return false;
}

}  // namespace kd
