#pragma once

namespace calotype {

/// From now on the first SIGINT or SIGTERM is only noted; another one, more than a fifth of a
/// second later, ends the program at once.
/// Signals of failing writes are ignored, so that the writes fail instead.
void catchInterrupts();

/// True once a signal came.
bool isInterrupted();

/// Throws Interrupted once a signal came.
void throwIfInterrupted();

} // namespace calotype
