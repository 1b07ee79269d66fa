#pragma once

#include "read/obj/mtl_file.h"
#include "read/obj/mtl_maps.h"
#include "read/obj/mtl_notes.h"

namespace calotype {

/// The grey of faces whose colour no statement of an MTL file gives.
constexpr double kUnstatedColor = 0.5;

/// The material of the scene that comes nearest to one of an MTL file; README.md has the mapping as
/// a table. Numbers out of range are clamped. What a user should know goes into `notes` under
/// `name`, the material's in the MTL file; the result has no name yet.
Material materialFromMtl(const MtlMaterial& mtl, const std::string& name, MtlMaps& maps,
                         MtlNotes& notes);

} // namespace calotype
