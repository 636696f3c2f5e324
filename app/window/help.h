// The help: all keys and gestures over a dimmed window.
#pragma once

#include "app/panels/edit.h"

namespace kd {

void draw_help(Edit& edit);

}  // namespace kd
