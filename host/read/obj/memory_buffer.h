#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <streambuf>
#include <string_view>

#include "base/progress.h"

namespace calotype {

/// A stream that reads from memory without copying. If `onProgress` throws, the stream ends.
class MemoryBuffer : public std::streambuf {
public:
    MemoryBuffer(std::string_view text, const OnProgress& onProgress)
        : text_(text), onProgress_(onProgress) {}

    /// Throws what `onProgress` has thrown. Streams do not pass on exceptions.
    void rethrow() const {
        if (failure_)
            std::rethrow_exception(failure_);
    }

protected:
    int_type underflow() override {
        constexpr size_t kPart = 1 << 20;
        const size_t size = std::min(kPart, text_.size() - next_);
        if (size == 0 || failure_ || !report())
            return traits_type::eof();
        char* start = const_cast<char*>(text_.data() + next_); // read only: there is no put area
        setg(start, start, start + size);
        next_ += size;
        return traits_type::to_int_type(*start);
    }

private:
    /// Returns false if the stream must end.
    bool report() {
        try {
            if (onProgress_)
                onProgress_(static_cast<double>(next_) / static_cast<double>(text_.size()));
        } catch (...) {
            failure_ = std::current_exception();
        }
        return !failure_;
    }

    std::string_view text_;
    const OnProgress& onProgress_;
    size_t next_ = 0; ///< of the text, not yet in the get area
    std::exception_ptr failure_;
};

} // namespace calotype
