// info: what this build and this machine can do.

#include <CLI/CLI.hpp>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <version.h>

#include "app/assets.h"
#include "app/commands/commands.h"
#include "app/fonts.h"
#include "app/report/json_values.h"
#include "app/report/machine_info.h"
#include "renderer/cpu/cpu_tracer.h"
#include "renderer/cpu/threads.h"
#include "renderer/gl/gl_tracer.h"
#include "renderer/gl/multiprocessors.h"
#include "renderer/peers/peers.h"
#include "renderer/scene/procedural.h"

namespace kd {

namespace {

struct Limit {
    const char* name;
    GLenum value;
};
constexpr std::array<Limit, 4> limits{{{"texture side", GL_MAX_TEXTURE_SIZE},
                                       {"texture buffer texels", GL_MAX_TEXTURE_BUFFER_SIZE},
                                       {"storage buffer bytes", GL_MAX_SHADER_STORAGE_BLOCK_SIZE},
                                       {"draw buffers", GL_MAX_DRAW_BUFFERS}}};

/// "passed", or what is wrong.
std::string self_test_result(Context& context) {
    try {
        const GlTracer tracer(context);
        return "passed";
    } catch (const GlError& error) {
        return error.what();
    }
}

std::string word(const Json& value) {
    return value.is_null() ? "none found" : value.is_string() ? value.get<std::string>() : value.dump();
}

/// Of either kind of shaders, at a picture of 1024 x 1024 pixels: those that work and those there are; what the driver
/// says where it refuses to tell; null where it cannot.
Json multiprocessor_info(Context& context) {
    Json json = nullptr;
    for (const auto& [name, mode] : {std::pair("fragment", GlMode::fragment), std::pair("compute", GlMode::compute)}) {
        try {
            const std::optional<Multiprocessors> counted = multiprocessors_used(context.gl(), mode, 1024, 1024);
            if (counted) json[name] = {{"used", counted->used}, {"there", counted->there}};
        } catch (const GlError& error) {
            json[name] = error.what();
        }
    }
    return json;
}

/// "fragment shaders: 12 of 132, compute shaders: 132 of 132".
std::string multiprocessor_text(const Json& kinds) {
    if (kinds.is_null()) return "not told by this driver";
    std::string list;
    for (const auto& [name, counted] : kinds.items()) {
        const std::string share = counted.is_string()
                                      ? word(counted)
                                      : fmt::format("{} of {}", word(counted["used"]), word(counted["there"]));
        list += fmt::format("{}{} shaders: {}", list.empty() ? "" : ", ", name, share);
    }
    return list;
}

Json context_info(ContextKind kind) {
    Json json{{"context", name_of(kind)}};
    try {
        const std::unique_ptr<Context> context = Context::create(kind);
        json["renderer"] = context->renderer();
        json["version"] = context->version();
        json["software"] = context->is_software();
        for (const Limit& limit : limits) {
            GLint value = 0;
            context->gl().GetIntegerv(limit.value, &value);
            json["limits"][limit.name] = value;
        }
        json["self_test"] = self_test_result(*context);
        json["multiprocessors"] = multiprocessor_info(*context);
    } catch (const ContextError& error) {
        json["unavailable"] = error.what();
    }
    return json;
}

Json font_info() {
    const FontFiles fonts = find_fonts();
    const auto path = [](const std::optional<std::filesystem::path>& file) {
        return file ? Json(file->string()) : Json(nullptr);
    };
    return {{"text", path(fonts.text)}, {"bold", path(fonts.bold)}, {"code", path(fonts.code)}};
}

Json scene_names() {
    Json names = Json::array();
    for (const ProceduralScene& scene : procedural_scenes())
        names.push_back(scene.default_size > 0 ? fmt::format("{}:{}", scene.name, scene.default_size)
                                               : std::string(scene.name));
    for (const auto& file : shipped_scenes()) names.push_back(file.filename().string());
    return names;
}

template <class Table>
Json names_of(const Table& table) {
    Json names = Json::array();
    for (const auto& entry : table) names.push_back(entry.name);
    return names;
}

Json collect() {
    Json json{{"version", build::version},
              {"commit", build::commit},
              {"compiler", build::compiler},
              {"build_type", build::build_type},
              {"flags", build::flags}};
#ifdef KD_WITH_WINDOW
    json["window"] = true;
#else
    json["window"] = false;
#endif
    json["cpu"] = {{"model", cpu_model()}, {"target", cpu_target_name()}, {"threads", default_threads()}};
    json["contexts"] = Json::array({context_info(ContextKind::osmesa), context_info(ContextKind::egl)});
    json["fonts"] = font_info();
    json["scenes"] = scene_names();
    json["builders"] = names_of(builders());
    json["traversals"] = names_of(traversals());
    json["tracers"] = names_of(choices::tracers());
    json["peers"] = peers_version().empty() ? Json(nullptr) : Json(peers_version());
    return json;
}

std::string word_list(const Json& values) {
    std::string list;
    for (const Json& value : values) list += (list.empty() ? "" : ", ") + word(value);
    return list;
}

void print(std::ostream& out, const Json& json) {
    const auto line = [&](const std::string& title, const std::string& text) {
        out << fmt::format("{:<12}{}\n", title, text);
    };
    line("kdscope", fmt::format("{} ({})", word(json["version"]), word(json["commit"])));
    line("compiler", word(json["compiler"]));
    line("flags", fmt::format("{} {}", word(json["build_type"]), word(json["flags"])));
    line("window", json["window"] == true ? "yes" : "left out of this build");
    line("CPU", fmt::format("{}, {}, {} threads", word(json["cpu"]["model"]), word(json["cpu"]["target"]),
                            word(json["cpu"]["threads"])));
    for (const Json& context : json["contexts"]) {
        if (context.contains("unavailable")) {
            line(word(context["context"]), "not available: " + word(context["unavailable"]));
            continue;
        }
        line(word(context["context"]),
             fmt::format("{}, OpenGL {}{}", word(context["renderer"]), word(context["version"]),
                         context["software"] == true ? ", software" : ""));
        std::string list;
        for (const auto& [name, value] : context["limits"].items())
            list += fmt::format("{}{} {}", list.empty() ? "" : ", ", name, word(value));
        line("", list);
        const std::string result = word(context["self_test"]);
        line("", result == "passed" ? "self-test passed" : result);
        line("", "multiprocessors at work: " + multiprocessor_text(context["multiprocessors"]));
    }
    for (const auto& [use, file] : json["fonts"].items()) line(use + " font", word(file));
    line("scenes", word_list(json["scenes"]));
    line("builders", word_list(json["builders"]));
    line("traversals", word_list(json["traversals"]));
    line("tracers", word_list(json["tracers"]));
    line("peers", word(json["peers"]));
}

CommandBody declare(CLI::App& app) {
    const auto json = std::make_shared<bool>(false);
    app.add_flag("--json", *json, "JSON instead of text");
    return [json](CommandContext& context) {
        const Json facts = collect();
        if (*json)
            context.out << json_text(facts);
        else
            print(context.out, facts);
        return int(exit_ok);
    };
}

}  // namespace

Command info_command() {
    return {"info", "Version, build, CPU, OpenGL contexts, fonts, known scenes",
            "Example:\n"
            "  kdscope info --json\n",
            declare};
}

}  // namespace kd
