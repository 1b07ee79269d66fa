#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "pack/gpu_scene.h"
#include "scene/texture.h"
#include "support/device_numbers.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"

/// Textures for tests, and how the kernels read them, packed as the program packs them.
namespace calotype::test {

/// Of linearFromSrgb, as it states, and of the arithmetic around it.
constexpr double kDecodingError = 1.5e-6;

struct ImageForm {
    uint32_t width;
    uint32_t height;
    bool holdsBytes;
    bool isEncoded;
};

/// Encoded values in [0, 1], others up to 20.
std::shared_ptr<const TexelImage> randomImage(const ImageForm& form, RandomNumbers& random);

Texture imageTexture(std::shared_ptr<const TexelImage> image, TextureWrap wrap,
                     TextureFilter filter);

const TexelImage& imageOf(const Texture& texture);

/// Every way to read each of some images, which two textures and more therefore share.
std::vector<Texture> variedTextures(const std::vector<ImageForm>& forms, RandomNumbers& random);

/// Textures packed together, each under the index that it has in the list. `isCutOut`: as colours
/// of materials with holes.
class PackedTextures {
public:
    explicit PackedTextures(std::vector<Texture> textures, bool isCutOut = false);

    std::vector<glm::vec4> read(const std::vector<shared::TestTextureRead>& reads) const;

    const std::vector<Texture>& textures() const { return textures_; }
    size_t rowCount() const { return calotype::rowCount(scene_.texelRows); }

private:
    std::vector<Texture> textures_;
    GpuScene scene_;
};

} // namespace calotype::test
