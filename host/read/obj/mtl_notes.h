#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/names.h"
#include "read/read_context.h"

namespace calotype {

/// Collects remarks about the materials of an OBJ: one warning for each remark.
class MtlNotes {
public:
    /// `remark` is a sentence that ends with the names of materials.
    void add(const std::string& remark, const std::string& material) {
        const auto found = std::ranges::find(notes_, remark, &Note::first);
        Note& note = found != notes_.end() ? *found : notes_.emplace_back(remark, Names());
        if (std::ranges::find(note.second, material) == note.second.end())
            note.second.push_back(material);
    }

    void warn(const std::string& where, ReadContext& context) const {
        for (const auto& [remark, materials] : notes_)
            context.warn(where, remark + " in " + listInQuotes(materials), remark);
    }

private:
    using Names = std::vector<std::string>;
    using Note = std::pair<std::string, Names>;
    std::vector<Note> notes_;
};

} // namespace calotype
