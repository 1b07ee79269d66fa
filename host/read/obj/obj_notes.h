#pragma once

#include <string>
#include <vector>

#include "read/obj/face_check.h"
#include "read/obj/outline.h"

namespace calotype {

/// A warning about a file: `kind` is a sentence, `message` the same with a number and places.
struct ObjNote {
    std::string kind;
    std::string message;
};

/// What is left out of an OBJ, or is not as written.
std::vector<ObjNote> notesOn(const ObjOutline& outline, const FaceFaults& faults);

/// About polygons of which Triangulator::sound is false.
ObjNote noteOfCrossingPolygons(uint64_t count);

} // namespace calotype
