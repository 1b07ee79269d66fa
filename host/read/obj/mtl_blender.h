#pragma once

#include <string>

#include "read/obj/mtl_file.h"
#include "read/obj/mtl_notes.h"

namespace calotype {

/// A material of an MTL file that Blender wrote, in the words of its PBR option: with Pr, Pm and
/// their maps, and transmission in place of Tf. Blender's default option states them by Ns, Ka, Ks,
/// illum and maps (docs/obj.md, "Blender"). Remarks about `name` are added to `notes`.
MtlMaterial inBlendersMeaning(MtlMaterial mtl, const std::string& name, MtlNotes& notes);

} // namespace calotype
