#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace calotype {

/// Sentences for the author of a scene. Many warnings of one kind become one sentence.
class Warnings {
public:
    /// Adds the warning "WHERE: MESSAGE", once. Warnings are of one kind if their `kind` is equal;
    /// it is not shown, and by default it is the message.
    void add(const std::string& where, const std::string& message, const std::string& kind = "");

    /// Adds all warnings of `others`, each once.
    void append(const Warnings& others);

    /// One for each kind, in the order of their first warnings: the first warning and, in
    /// parentheses, the number of the others and the places of two of them.
    std::vector<std::string> sentences() const;

private:
    struct Warning {
        std::string where;
        std::string message;
        std::string kind;
    };
    std::vector<Warning> warnings_;
    std::set<std::pair<std::string, std::string>> known_; ///< places and messages
};

} // namespace calotype
