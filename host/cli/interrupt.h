#pragma once

namespace calotype {

/// After this call, the first SIGINT or SIGTERM only sets a flag; another one, more than a fifth of
/// a second later, ends the program at once.
/// Signals of failing writes are ignored, so that the writes fail instead.
void catchInterrupts();

/// True after a signal.
bool isInterrupted();

/// Throws Interrupted after a signal.
void throwIfInterrupted();

} // namespace calotype
