#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace calotype {

/// How often something occurs in a file, and in which lines first.
class Occurrences {
public:
    void add(size_t line) {
        ++count_;
        if (lines_.size() < kNamed)
            lines_.push_back(line);
    }

    uint64_t count() const { return count_; }

    /// "1 (line 7)", "2 (lines 7, 9)", "12 (lines 7, 9, 15, ...)"
    std::string text() const {
        std::string text = std::to_string(count_) + (count_ > 1 ? " (lines " : " (line ");
        for (size_t i = 0; i < lines_.size(); ++i)
            text += (i > 0 ? ", " : "") + std::to_string(lines_[i]);
        return text + (count_ > kNamed ? ", ...)" : ")");
    }

private:
    static constexpr size_t kNamed = 3;
    uint64_t count_ = 0;
    std::vector<size_t> lines_; ///< the first few
};

} // namespace calotype
