#include "app/cli/error_text.h"

#include <fmt/format.h>
#include <new>

namespace kd {

std::string error_text(const std::exception& error, std::string_view what) {
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return fmt::format("{}: not enough memory; use a smaller scene or picture", what);
    return error.what();
}

}  // namespace kd
