#include "app/camera_text.h"

#include "app/report/json_values.h"
#include "renderer/geometry/input_error.h"

namespace kd {

namespace {

Vec3 vector_of(const Json& json) {
    const auto v = json.get<std::array<float, 3>>();
    return {v[0], v[1], v[2]};
}

}  // namespace

std::string camera_text(const Camera& camera) { return json_of(camera).dump(); }

Camera parse_camera(const std::string& text) {
    const InputError refused("camera: the text is no camera; copy one with Ctrl+C, as "
                             R"({"eye":[0,0,3],"target":[0,0,0],"up":[0,1,0],"fov":45})");
    Camera camera;
    try {
        const Json json = Json::parse(text);
        camera.eye = vector_of(json.at("eye"));
        camera.target = vector_of(json.at("target"));
        if (json.contains("up")) camera.up = vector_of(json.at("up"));
        if (json.contains("fov")) camera.fov_y_degrees = json.at("fov").get<float>();
    } catch (const Json::exception&) {
        throw refused;
    }
    if (!is_valid(camera) || camera.up == Vec3(0)) throw refused;  // as options and session files are
    return camera;
}

}  // namespace kd
