#include "read/obj/face_check.h"

#include <string>
#include <utility>
#include <vector>

#include "base/text_cursor.h"
#include "read/obj/lines.h"

namespace calotype {
namespace {

class FaceChecker {
public:
    explicit FaceChecker(const ObjOutline& outline) : outline_(outline) {}

    void addLine(size_t number, std::string_view line) {
        TextCursor cursor(line);
        const std::string keyword = objKeyword(cursor);
        if (keyword == "v")
            ++counts_[kObjPosition];
        else if (keyword == "vt")
            ++counts_[kObjTexcoord];
        else if (keyword == "vn")
            ++counts_[kObjNormal];
        else if (keyword == "f")
            addFace(number, cursor);
    }

    FaceFaults take() && { return std::move(faults_); }

private:
    using DataState = ObjOutline::DataState;

    void addFace(size_t number, const TextCursor& cursor) {
        if (!parseObjFace(cursor, face_) || face_.size() < 3)
            return;
        for (const ObjData kind : {kObjPosition, kObjTexcoord, kObjNormal})
            if (!addFault(number, kind) && kind == kObjPosition)
                return; // the face is left out, so the rest does not matter
    }

    /// True if there is no fault of this kind.
    bool addFault(size_t number, ObjData kind) {
        if (isPartial(face_, kind)) {
            faults_.partial[kind].add(number);
            return false;
        }
        for (const ObjCorner& corner : face_) {
            if (!corner[kind])
                continue;
            const uint32_t index = resolveObjIndex(corner[kind], counts_[kind]);
            const DataState state = outline_.stateOf(kind, index);
            if (state == DataState::Usable)
                continue;
            if (state == DataState::Missing)
                faults_.missing[kind].add(number);
            else
                addUnusable(number, kind, index);
            return false;
        }
        return true;
    }

    void addUnusable(size_t number, ObjData kind, uint32_t index) {
        const auto found = outline_.unreadable[kind].find(index);
        if (found == outline_.unreadable[kind].end())
            return faults_.unusable[kind].add(number);
        if (faults_.unreadable[kind].count() == 0)
            faults_.firstUnreadable[kind] =
                "line " + std::to_string(found->second.line) + ": " + found->second.message;
        faults_.unreadable[kind].add(number);
    }

    const ObjOutline& outline_;
    std::array<size_t, kObjDataCount> counts_{}; ///< of vertex data so far
    std::vector<ObjCorner> face_;
    FaceFaults faults_;
};

} // namespace

FaceFaults checkFaces(std::string_view text, const ObjOutline& outline,
                      const OnProgress& onProgress) {
    FaceChecker checker(outline);
    const size_t lines = lineCount(text);
    forEachObjLine(text, [&](size_t number, std::string_view line) {
        reportStep(onProgress, number, lines);
        checker.addLine(number, line);
    });
    return std::move(checker).take();
}

} // namespace calotype
