#pragma once

#include "accel/bvh.h"
#include "shared/scene_structs.h"

namespace calotype {

/// What a node's leaves begin with, among the packed triangles and among the packed quadrics.
struct FirstPrimitives {
    uint32_t triangle = 0;
    uint32_t quadric = 0;
};

/// A node with the boxes of its children on a grid of 255 cells a side over its own box (Ylitie,
/// Karras and Laine 2017, section 3.1): each contains the exact one, however large, small or far
/// from the origin.
shared::BvhNode packNode(const Bvh::Node& node, const FirstPrimitives& first, uint32_t childBase);

} // namespace calotype
