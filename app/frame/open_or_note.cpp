#include "app/frame/open_or_note.h"

#include "renderer/geometry/input_error.h"
#include "renderer/gl/context.h"

namespace kd {

void open_or_note(AskedFor asked, const std::function<void()>& open,
                  const std::function<void(const std::string& why)>& note) {
    try {
        open();
    } catch (const ContextError& error) {
        if (asked.tracer || asked.context) throw;
        note(error.what());
    } catch (const InputError& error) {
        if (asked.tracer) throw;
        note(error.what());
    }
}

}  // namespace kd
