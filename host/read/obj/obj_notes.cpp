#include "read/obj/obj_notes.h"

#include "base/names.h"

namespace calotype {
namespace {

void addNote(std::vector<ObjNote>& notes, const Occurrences& occurrences, const std::string& kind) {
    if (occurrences.count() > 0)
        notes.push_back({kind, kind + ": " + occurrences.text()});
}

/// `first` is about the first data that cannot be read.
void addUnreadable(std::vector<ObjNote>& notes, const Occurrences& occurrences,
                   const std::string& kind, const std::string& first) {
    if (occurrences.count() > 0)
        notes.push_back({kind, kind + ": " + occurrences.text() + "; " + first});
}

} // namespace

std::vector<ObjNote> notesOn(const ObjOutline& outline, const FaceFaults& faults) {
    std::vector<ObjNote> notes;
    addNote(notes, outline.smallFaces, "faces left out because they have fewer than 3 corners");
    addNote(notes, outline.unreadableFaces,
            "faces left out because a corner cannot be read (corners are like 1, 1/2, 1//3 or "
            "1/2/3)");
    addNote(notes, faults.missing[kObjPosition],
            "faces left out because a position that they name does not exist");
    addNote(notes, faults.unusable[kObjPosition],
            "faces left out because a position that they name is not finite");
    addUnreadable(notes, faults.unreadable[kObjPosition],
                  "faces left out because a position that they name cannot be read",
                  faults.firstUnreadable[kObjPosition]);
    addNote(notes, faults.missing[kObjTexcoord],
            "faces without texture coordinates because one that they name does not exist");
    addNote(notes, faults.unusable[kObjTexcoord],
            "faces without texture coordinates because one that they name is not finite or beyond "
            "1e9");
    addUnreadable(notes, faults.unreadable[kObjTexcoord],
                  "faces without texture coordinates because one that they name cannot be read",
                  faults.firstUnreadable[kObjTexcoord]);
    addNote(notes, faults.partial[kObjTexcoord],
            "faces without texture coordinates because only some corners name one");
    addNote(notes, faults.missing[kObjNormal],
            "faces shown flat because a normal that they name does not exist");
    addNote(notes, faults.unusable[kObjNormal],
            "faces shown flat because a normal that they name is zero or not finite");
    addUnreadable(notes, faults.unreadable[kObjNormal],
                  "faces shown flat because a normal that they name cannot be read",
                  faults.firstUnreadable[kObjNormal]);
    addNote(notes, faults.partial[kObjNormal],
            "faces whose normals were ignored because only some corners name one");
    addNote(notes, outline.coloredLines,
            "colours of vertices are not rendered (a texture can show them)");
    addNote(notes, outline.unrendered,
            "statements that are not rendered, " + listInQuotes(outline.unrenderedKeywords));
    return notes;
}

ObjNote noteOfCrossingPolygons(uint64_t count) {
    const std::string kind = "polygons that cross themselves or are far from flat, cut into "
                             "triangles that may overlap";
    return {kind, kind + ": " + std::to_string(count)};
}

} // namespace calotype
