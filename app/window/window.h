// The window: the picture in the middle, panels around it.
#pragma once

#include <stop_token>

#include "app/session.h"

namespace kd {

/// Shows `start` until the window is closed or `stop` is requested, and returns the exit code. NoDisplay where no
/// window can be opened.
[[nodiscard]] int run_window(const Session& start, std::stop_token stop = {});

}  // namespace kd
