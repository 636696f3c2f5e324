#include "app/session_file.h"
#include "renderer/geometry/input_error.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/targets.h"

namespace kd::fuzz {

void session(std::string_view bytes) {
    // In no folder: a scene's name is then the same in the file and beside it.
    const std::string file = "fuzz.session.json";
    Session read;
    try {
        read = parse_session(std::string(bytes), file);
    } catch (const InputError& error) {
        promise_one_line(error.what());
        promise(std::string_view(error.what()).starts_with(file + ": "), "errors name the file");
        return;
    }
    const std::string text = session_text(file, read);
    const Session again = parse_session(text, file);
    promise(again == read, "every field comes back");
    promise(session_text(file, again) == text, "and is written alike, zeros with their signs");
}

}  // namespace kd::fuzz
