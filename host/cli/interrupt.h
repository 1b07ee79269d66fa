#pragma once

namespace calotype {

/// After this call, the first of these signals only sets a flag: SIGINT and SIGTERM; SIGHUP, of a
/// terminal that is closed; SIGXCPU, SIGUSR1 and SIGUSR2, with which batch systems announce the end
/// of a job's time. A later SIGINT or SIGTERM, more than a fifth of a second after the first
/// signal, ends the program at once. A signal that is ignored at the start, as by nohup, stays
/// ignored.
/// Signals of failing writes are ignored, so that the writes fail instead.
void catchInterrupts();

/// True after a signal.
bool isInterrupted();

/// Throws Interrupted after a signal: for commands that sample.
void throwIfInterrupted();

/// Throws Error after a signal, with this sentence: for commands that do not.
void throwIfInterrupted(const char* sentence);

} // namespace calotype
