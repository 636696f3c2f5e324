#include "app/session_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "app/assets.h"
#include "app/session_reader.h"
#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/gltf.h"
#include "renderer/io/printable.h"

namespace kd {

namespace fs = std::filesystem;

namespace {

constexpr int version = 1;
constexpr const char* version_key = "kdscope_session";
constexpr std::size_t most_bytes = 1 << 20;
constexpr int deepest = 16;  // objects and arrays in each other; a session has five

/// Text after "[json.exception.parse_error.101] ", which is of no use to people.
std::string reason(const Json::exception& error) {
    const std::string text = error.what();
    const std::size_t end = text.find("] ");
    return printable(end == std::string::npos ? text : text.substr(end + 2), 200);
}

/// Goes along with the parser and refuses what is JSON but no session: nesting without end, and a key twice, of which
/// the parser would keep the last.
class StrictKeys {
  public:
    explicit StrictKeys(const std::string& file) : file_(file) {}

    void see(int depth, Json::parse_event_t event, const Json& parsed) {
        if (depth > deepest) throw InputError(fmt::format("{}: nested deeper than any session file", file_));
        if (event == Json::parse_event_t::object_start) open_.emplace_back();
        if (event == Json::parse_event_t::object_end) open_.pop_back();
        if (event == Json::parse_event_t::key) take(parsed.get<std::string>());
    }

  private:
    void take(const std::string& key) {
        std::vector<std::string>& keys = open_.back();
        const bool again = std::ranges::find(keys, key) != keys.end();
        keys.push_back(key);
        if (!again) return;
        std::string place;
        for (const std::vector<std::string>& object : open_) place += "/" + printable(object.back());
        throw InputError(fmt::format("{}: {}: the key is there twice; leave one out", file_, place));
    }

    const std::string& file_;
    std::vector<std::vector<std::string>> open_;  // keys so far of the objects that the parser is in, outermost first
};

Json parse(const std::string& text, const std::string& file) {
    StrictKeys keys(file);
    const auto watch = [&](int depth, Json::parse_event_t event, const Json& parsed) {
        keys.see(depth, event, parsed);
        return true;
    };
    try {
        return Json::parse(text, watch);
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: {}", file, reason(error)));
    }
}

/// Before anything else is looked at: what a newer program writes, this one cannot judge.
void check_version(const Json& json, const std::string& file) {
    if (!json.is_object() || !json.contains(version_key))
        throw InputError(fmt::format("{}: not a session file: there is no key {}", file, version_key));
    const Json& found = json[version_key];
    if (found == version) return;
    const bool newer = found.is_number_integer() && found > version;
    throw InputError(fmt::format("{}: /{}: {}", file, version_key,
                                 newer ? fmt::format("written by a newer kdscope; this one reads version {}", version)
                                       : fmt::format("must be {}", version)));
}

/// What can be wrong though each field alone is right.
void check_together(const ViewConfig& view, const FieldReader& settings) {
    if (!has_valid_tile(view.map)) settings.refuse("view/map", "a tile must have 4 to 1024 pixels");
    if (!view.show_map) return;
    try {
        (void)compute_map(Frame(1, 1), view.map);
    } catch (const InputError& error) {
        settings.refuse("view/map", error.what());
    }
}

/// A relative scene file as seen from where the program runs. A bare name may also be that of a scene that comes with
/// the program.
std::string scene_seen_from(const fs::path& folder, const std::string& scene) {
    const fs::path path(scene);
    if (!names_gltf(path) || path.is_absolute()) return scene;
    const fs::path beside = (folder / path).lexically_normal();
    std::error_code error;
    const bool shipped = !path.has_parent_path() && find_asset("scenes/" + scene);
    return shipped && !fs::exists(beside, error) ? scene : beside.string();
}

/// The way back: files that move with the session's folder are named from there.
std::string scene_named_from(const fs::path& folder, const std::string& scene) {
    std::error_code error;
    if (!names_gltf(scene) || !fs::exists(scene, error)) return scene;
    const fs::path path = fs::absolute(scene).lexically_normal();
    const fs::path below = path.lexically_relative(fs::absolute(folder).lexically_normal());
    return below.empty() || *below.begin() == ".." ? path.string() : below.string();
}

}  // namespace

bool names_session(const std::string& name) { return fs::path(name).extension() == ".json"; }

std::string scene_fault(const std::string& file, const std::string& why) {
    return fmt::format("{}: /settings/scene: {}", printable(file, 4096), why);
}

Session read_session(const fs::path& path) { return parse_session(read_file(path, most_bytes), path); }

Session parse_session(const std::string& text, const fs::path& path) {
    const std::string file = printable(path.string(), 4096);
    const Json json = parse(text, file);
    check_version(json, file);
    Session session;
    FieldReader whole(json, file);
    int read = version;
    whole.number(version_key, read, Limits<int>{version, version});
    whole.object("settings", [&](FieldReader& settings) {
        visit_session(settings, session);
        settings.object("view", [&](FieldReader& view) { visit_view(view, session.view); });
        check_together(session.view, settings);
    });
    whole.refuse_others();
    session.scene = scene_seen_from(path.parent_path(), session.scene);
    return session;
}

void write_session(const fs::path& path, const Session& session) { write_file(path, session_text(path, session)); }

std::string session_text(const fs::path& path, const Session& session) {
    Session named = session;
    named.scene = scene_named_from(path.parent_path(), session.scene);
    const Json json{{version_key, version}, {"settings", settings_json(named, named.view)}};
    try {
        return json.dump(2) + "\n";
    } catch (const Json::exception&) {
        throw InputError(fmt::format("{}: the scene's path '{}' is not UTF-8, which JSON cannot hold; rename the file",
                                     printable(path.string(), 4096), printable(named.scene, 1000)));
    }
}

}  // namespace kd
