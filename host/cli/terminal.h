#pragma once

#include <cstddef>

namespace calotype {

/// Whether standard error is a terminal that can redraw a line: not one of TERM=dumb, or without
/// TERM.
bool canRedrawLines();

/// The width of the terminal of standard error at this moment; COLUMNS, or else 80, where the
/// terminal does not say it.
size_t terminalColumns();

/// Occupies standard input, output and error where they are closed, so that no file of a render
/// gets their numbers, and messages go into it. Writing to them still fails.
void occupyClosedStreams();

} // namespace calotype
