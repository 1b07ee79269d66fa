#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/names.h"
#include "base/number_text.h"
#include "base/range.h"
#include "read/read_context.h"

namespace calotype {

/// Collects remarks about the materials of an OBJ: one warning for each remark.
class MtlNotes {
public:
    /// `remark` is a sentence that ends with the names of materials. All remarks about a material
    /// must be added before those about the next.
    void add(const std::string& remark, const std::string& material) {
        const auto found = std::ranges::find(notes_, remark, &Note::first);
        Note& note = found != notes_.end() ? *found : notes_.emplace_back(remark, Names());
        if (note.second.empty() || note.second.back() != material)
            note.second.push_back(material);
    }

    /// `value` clamped to a closed range, with a remark if that changes it.
    double clamped(const std::string& statement, double value, const Range& range,
                   const std::string& material) {
        const std::string low = shortNumber(range.low);
        const std::string high = shortNumber(range.high);
        if (value < range.low)
            add(statement + " below " + low + " was raised to " + low, material);
        else if (value > range.high)
            add(statement + " above " + high + " was lowered to " + high, material);
        return std::clamp(value, range.low, range.high);
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
