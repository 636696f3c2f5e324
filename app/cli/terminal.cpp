#include "app/cli/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include "app/cli/text_table.h"

namespace kd {

std::size_t terminal_width() {
    winsize size{};
    const bool known = ::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0;
    return known && size.ws_col > 0 ? size.ws_col : usual_width;
}

}  // namespace kd
