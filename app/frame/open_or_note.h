// Opening a tracer that may not be there: what was asked for by name has to be, the rest is left out with a note.
#pragma once

#include <functional>
#include <string>

namespace kd {

/// What a person asked for by name.
struct AskedFor {
    bool tracer = false, context = false;
};

/// Calls `open`. Where a context is not there (ContextError) and neither it nor the tracer was asked for, or the tracer
/// refuses (InputError) and was not asked for, `note` gets the reason; else the error goes on.
void open_or_note(AskedFor asked, const std::function<void()>& open,
                  const std::function<void(const std::string& why)>& note);

}  // namespace kd
