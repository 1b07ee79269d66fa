#pragma once

#include "accel/binary_tree.h"
#include "accel/bvh.h"

namespace calotype {

/// Cost of visiting a node, relative to testing a primitive.
constexpr float kNodeCost = 3.0f;

/// Joins the nodes of a binary tree to nodes of up to eight children and leaves of up to three
/// primitives, with the least expected cost of a random ray (Ylitie, Karras and Laine 2017,
/// "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", section 3.2).
Bvh collapse(const BinaryTree& tree, std::span<const Primitive> primitives, uint32_t threads);

} // namespace calotype
