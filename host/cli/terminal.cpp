#include "cli/terminal.h"

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "settings/value_text.h"

namespace calotype {

bool canRedrawLines() {
    const char* term = std::getenv("TERM");
    return term != nullptr && *term != '\0' && std::string_view(term) != "dumb" &&
           isatty(STDERR_FILENO) != 0;
}

size_t terminalColumns() {
    constexpr size_t kUsual = 80;
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return size.ws_col;
    const char* variable = std::getenv("COLUMNS");
    const auto columns = parseNumber<uint16_t>(variable ? variable : "");
    return columns && *columns > 0 ? *columns : kUsual;
}

void occupyClosedStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0 && errno == EBADF)
            (void)open("/dev/null", O_RDONLY); // the lowest number that is free: this one
}

} // namespace calotype
