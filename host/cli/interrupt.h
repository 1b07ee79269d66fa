#pragma once

#include "base/error.h"

namespace calotype {

/// Thrown where an interrupt ends work that has nothing to show yet.
class Interrupted : public Error {
public:
    Interrupted() : Error("interrupted before the first sample; nothing was written") {}
};

/// From now on the first SIGINT or SIGTERM is only noted; another one, more than a fifth of a
/// second later, ends the program at once.
/// Signals of failing writes are ignored, so that the writes fail instead.
void catchInterrupts();

/// True once a signal came.
bool isInterrupted();

} // namespace calotype
