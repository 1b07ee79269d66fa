#pragma once

#include "read/obj/mtl_file.h"
#include "read/obj/mtl_kind.h"
#include "read/obj/mtl_maps.h"
#include "read/obj/mtl_notes.h"

namespace calotype {

/// The material of the scene that is most similar to one of an MTL file; docs/obj.md has the
/// mapping as tables. Numbers out of range are clamped. Adds remarks for the user to `notes` under
/// `name`, the material's name in the MTL file; the result has no name yet.
Material materialFromMtl(const MtlMaterial& mtl, const std::string& name, MtlMaps& maps,
                         MtlNotes& notes);

/// Visits the maps whose images materialFromMtl is sure to use (see MtlKind::visitImages).
void visitImagesOf(const MtlMaterial& mtl, const MtlKind::VisitImage& visit);

} // namespace calotype
