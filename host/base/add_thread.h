#pragma once

#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace calotype {

/// Adds a thread that does `work`. False if the system gives none, as at its limit of processes:
/// then the work is left to the threads that there are.
template <typename Work>
bool addThread(std::vector<std::jthread>& threads, Work&& work) {
    try {
        threads.emplace_back(std::forward<Work>(work));
        return true;
    } catch (const std::system_error&) {
        return false;
    }
}

} // namespace calotype
