#include "app/commands/verify_scenes.h"

#include <ostream>

#include "app/cli/progress_line.h"

namespace kd {

int check_scenes(const CommonOptions& options, bool as_json, CommandContext& context, const CheckScene& check) {
    require_context(options, true);
    bool passed = true;
    Json json = Json::array();
    for (const std::string& name : options.scenes) {
        Session session = options.session_for(name);
        const FlatScene scene = open_scene(options, session, context);
        const CheckedScene checked = [&] {
            ProgressLine progress(context);
            return check(session, scene,
                         [&](float done, const std::string& what) { progress.show(done, name + ": " + what); });
        }();
        check_stop(context);
        passed = passed && checked.passed;
        if (as_json) {
            json.push_back(checked.json);
            continue;
        }
        if (name != options.scenes.front()) context.out << '\n';
        checked.print(context.out);
        context.out.flush();
    }
    if (as_json) context.out << json_text(json);
    return passed ? exit_ok : exit_check_failed;
}

}  // namespace kd
