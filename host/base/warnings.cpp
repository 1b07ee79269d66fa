#include "base/warnings.h"

#include <cstddef>
#include <map>

namespace calotype {
namespace {

/// Warnings of one kind.
struct Group {
    std::string first; ///< "WHERE: MESSAGE"
    size_t others = 0;
    std::string otherPlaces; ///< of the first few
};

constexpr size_t kNamedOthers = 2;

void addOther(Group& group, const std::string& where) {
    if (group.others < kNamedOthers)
        group.otherPlaces += (group.others > 0 ? ", " : "") + where;
    ++group.others;
}

std::string sentenceOf(const Group& group) {
    if (group.others == 0)
        return group.first;
    return group.first + " (and " + std::to_string(group.others) + " more of this kind, at " +
           group.otherPlaces + (group.others > kNamedOthers ? ", ...)" : ")");
}

} // namespace

void Warnings::add(const std::string& where, const std::string& message, const std::string& kind) {
    if (known_.emplace(where, message).second)
        warnings_.push_back({where, message, kind.empty() ? message : kind});
}

void Warnings::append(const Warnings& others) {
    for (const Warning& other : others.warnings_)
        add(other.where, other.message, other.kind);
}

std::vector<std::string> Warnings::sentences() const {
    std::vector<Group> groups;
    std::map<std::string, size_t> groupOfKind;
    for (const Warning& warning : warnings_) {
        const auto [found, isNew] = groupOfKind.try_emplace(warning.kind, groups.size());
        if (isNew)
            groups.push_back({warning.where + ": " + warning.message, 0, ""});
        else
            addOther(groups[found->second], warning.where);
    }
    std::vector<std::string> sentences;
    for (const Group& group : groups)
        sentences.push_back(sentenceOf(group));
    return sentences;
}

} // namespace calotype
