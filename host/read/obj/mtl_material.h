#pragma once

#include "read/obj/mtl_file.h"
#include "read/obj/mtl_maps.h"
#include "read/obj/mtl_notes.h"

namespace calotype {

/// The grey of faces whose MTL file gives no colour.
constexpr double kUnstatedColor = 0.5;

/// The material of the scene that is most similar to one of an MTL file; docs/obj.md has the
/// mapping as tables. Numbers out of range are clamped. Adds remarks for the user to `notes` under
/// `name`, the material's name in the MTL file; the result has no name yet.
Material materialFromMtl(const MtlMaterial& mtl, const std::string& name, MtlMaps& maps,
                         MtlNotes& notes);

} // namespace calotype
