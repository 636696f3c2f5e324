// A camera as a line of JSON: what people copy from one window and paste into another, or into a script.
#pragma once

#include <string>

#include "renderer/scene/camera.h"

namespace kd {

/// {"eye":[x,y,z],"target":[x,y,z],"up":[x,y,z],"fov":degrees}, with the keys of the settings in every JSON file.
[[nodiscard]] std::string camera_text(const Camera& camera);

/// Takes it back; `up` and `fov` may be missing. InputError where `text` is no camera.
[[nodiscard]] Camera parse_camera(const std::string& text);

}  // namespace kd
