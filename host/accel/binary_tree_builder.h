#pragma once

#include <functional>
#include <span>

#include "accel/binary_tree.h"
#include "accel/primitive.h"
#include "base/fork_join.h"
#include "base/parallel_chunks.h"

namespace calotype {

/// A primitive's box, as builders sort it.
struct BoxReference {
    glm::vec3 lower;
    uint32_t number; ///< of the primitive
    glm::vec3 upper;
    uint32_t pad;

    Bounds3f bounds() const { return {lower, upper}; }
    glm::vec3 doubledCenter() const { return lower + upper; }
};

struct BuildOptions {
    uint32_t threads = allCores();
    /// Called with the share of primitives that are in leaves, in [0, 1]; may throw to end the
    /// build. Called only on the thread that called the builder.
    std::function<void(double)> onProgress = {};
};

/// Splits a range of primitives, then each part, on several threads. `split(references, depth,
/// threads)` gets two or more references. It moves those of the left child to the front and returns
/// their number, at least 1 and less than all; it may use `threads` threads.
template <typename Split>
class BinaryTreeBuilder {
public:
    BinaryTreeBuilder(std::span<const Primitive> primitives, const BuildOptions& options,
                      Split split)
        : options_(options), split_(split) {
        references_.resize(primitives.size());
        parallelChunks(primitives.size(), options.threads, [&](uint64_t first, uint64_t last) {
            for (auto i = static_cast<uint32_t>(first); i < last; ++i)
                references_[i] = {primitives[i].bounds.lower, i, primitives[i].bounds.upper, 0};
        });
    }

    BinaryTree build() {
        if (references_.empty())
            return {};
        tree_.nodes.resize(2 * references_.size() - 1);
        tree_.order.resize(references_.size());
        buildNode(0, references_, 0, true);
        return std::move(tree_);
    }

private:
    void buildNode(uint32_t index, std::span<BoxReference> references, uint32_t depth,
                   bool reports) {
        BinaryTree::Node& node = tree_.nodes[index];
        node.first = static_cast<uint32_t>(references.data() - references_.data());
        node.count = static_cast<uint32_t>(references.size());
        if (references.size() == 1) {
            node.bounds = references[0].bounds();
            tree_.order[node.first] = references[0].number;
            return;
        }
        const auto leftCount = static_cast<uint32_t>(
            split_(references, depth, std::max(1u, options_.threads >> std::min(depth, 31u))));
        const uint32_t left = BinaryTree::leftOf(index);
        const uint32_t right = index + 2 * leftCount;
        const bool forks = isWorthForking(references.size(), depth, options_.threads);
        forkJoin(
            forks,
            [&] { buildNode(left, references.first(leftCount), depth + 1, reports && !forks); },
            [&] { buildNode(right, references.subspan(leftCount), depth + 1, reports); });
        node.bounds = tree_.nodes[left].bounds;
        node.bounds.extend(tree_.nodes[right].bounds);
        if (reports)
            report(node);
    }

    void report(const BinaryTree::Node& node) const {
        constexpr uint32_t kPrimitivesPerReport = 1 << 15;
        if (options_.onProgress && node.count >= kPrimitivesPerReport)
            options_.onProgress(static_cast<double>(node.first + node.count) /
                                static_cast<double>(references_.size()));
    }

    const BuildOptions& options_;
    Split split_;
    std::vector<BoxReference> references_;
    BinaryTree tree_;
};

} // namespace calotype
