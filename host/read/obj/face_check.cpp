#include "read/obj/face_check.h"

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "base/text_cursor.h"
#include "read/obj/lines.h"

namespace calotype {
namespace {

class FaceChecker {
public:
    FaceChecker(const std::string& path, const ObjOutline& outline)
        : path_(path), outline_(outline) {}

    void addLine(size_t number, std::string_view line) {
        TextCursor cursor(line);
        const std::string_view keyword = cursor.word();
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

    void addFace(size_t number, TextCursor& cursor) {
        face_.clear();
        while (!cursor.atEnd())
            face_.push_back(parseObjCorner(cursor.word()).value_or(ObjCorner()));
        if (face_.size() < 3)
            return;
        for (const ObjData kind : {kObjPosition, kObjTexcoord, kObjNormal}) {
            const DataState state = worstOf(kind);
            if (state == DataState::Usable)
                continue;
            (state == DataState::Missing ? faults_.missing : faults_.unusable)[kind].add(number);
            if (kind == kObjPosition)
                return; // the face is left out, so the rest does not matter
        }
    }

    /// Of the face's corners: that of the first which is not usable.
    DataState worstOf(ObjData kind) const {
        DataState worst = DataState::Usable;
        for (const ObjCorner& corner : face_) {
            if (!corner[kind])
                continue;
            const uint32_t index = resolveObjIndex(corner[kind], counts_[kind]);
            requireReadable(kind, index);
            if (worst == DataState::Usable)
                worst = outline_.stateOf(kind, index);
        }
        return worst;
    }

    void requireReadable(ObjData kind, uint32_t index) const {
        const auto found = outline_.unreadable[kind].find(index);
        if (found != outline_.unreadable[kind].end())
            throw SceneError(path_ + ":" + std::to_string(found->second.line),
                             found->second.message);
    }

    const std::string& path_;
    const ObjOutline& outline_;
    std::array<size_t, kObjDataCount> counts_{}; ///< of vertex data so far
    std::vector<ObjCorner> face_;
    FaceFaults faults_;
};

} // namespace

FaceFaults checkFaces(std::string_view text, const std::string& path, const ObjOutline& outline,
                      const OnProgress& onProgress) {
    FaceChecker checker(path, outline);
    const size_t lines = lineCount(text);
    forEachObjLine(text, [&](size_t number, std::string_view line) {
        reportStep(onProgress, number, lines);
        checker.addLine(number, line);
    });
    return std::move(checker).take();
}

} // namespace calotype
