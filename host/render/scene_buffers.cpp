#include "render/scene_buffers.h"

#include <span>

#include "shared/bindings.h"

namespace calotype {

namespace {

TexelBuffer uploadRows(const Device& device, const auto& array, const char* name) {
    return {device, std::as_bytes(std::span(array)), name};
}

TexelBuffer uploadRows(const Device& device, const std::vector<TexelRows>& images,
                       const char* name) {
    std::vector<std::span<const std::byte>> parts;
    parts.reserve(images.size());
    for (const TexelRows& rows : images)
        parts.push_back(rows.bytes());
    return {device, parts, name};
}

} // namespace

SceneBuffers::SceneBuffers(const Device& device, const GpuScene& scene) {
    const auto upload = [&](uint32_t binding, const auto& array, const char* name) {
        buffers_.push_back({binding, uploadRows(device, array, name)});
    };
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people) SCENE_ROWS(id, shared::type, member, people)
#define SCENE_ROWS(id, type, member, people) upload(shared::kBinding##id, scene.member, people);
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"
}

std::vector<Binding> SceneBuffers::bindings() const {
    std::vector<Binding> bindings;
    for (const BoundBuffer& buffer : buffers_)
        bindings.push_back(Binding::texelBuffer(buffer.binding, buffer.rows));
    return bindings;
}

} // namespace calotype
