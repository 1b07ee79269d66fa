#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace calotype {

/// Sentences for the author of a scene, each once, in the order in which they were added.
class Warnings {
public:
    /// Adds the sentence "WHERE: MESSAGE".
    void add(const std::string& where, const std::string& message) {
        std::string sentence = where + ": " + message;
        if (std::ranges::find(sentences_, sentence) == sentences_.end())
            sentences_.push_back(std::move(sentence));
    }

    const std::vector<std::string>& sentences() const { return sentences_; }

private:
    std::vector<std::string> sentences_;
};

} // namespace calotype
