#pragma once

#include "accel/bvh.h"
#include "shared/scene_structs.h"

namespace calotype {

/// The first primitives of a node's leaves, among the packed triangles and quadrics.
struct FirstPrimitives {
    uint32_t triangle = 0;
    uint32_t quadric = 0;
};

/// A node with its children's boxes on a grid of 255 cells a side over its own box (Ylitie, Karras
/// and Laine 2017, section 3.1). Each packed box contains the exact one, at every size and distance
/// from the origin.
shared::BvhNode packNode(const Bvh::Node& node, const FirstPrimitives& first, uint32_t childBase);

} // namespace calotype
