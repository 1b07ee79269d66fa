#pragma once

#include <string>

#include "base/error.h"

namespace calotype {

/// Collects the failures of several outputs, so that each of them is tried.
class OutputFailures {
public:
    /// Calls `write`; keeps the message if it throws OutputError.
    template <typename Write>
    void attempt(const Write& write) {
        try {
            write();
        } catch (const OutputError& error) {
            messages_ += (messages_.empty() ? "" : "; and ") + std::string(error.what());
        }
    }

    /// Throws one OutputError with all messages, if there are any.
    void throwIfAny() const {
        if (!messages_.empty())
            throw OutputError(messages_);
    }

private:
    std::string messages_;
};

} // namespace calotype
