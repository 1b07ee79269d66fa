#include "support/packed_textures.h"

#include "kernels/texture_read.spv.h"
#include "pack/pack_textures.h"
#include "render/scene_buffers.h"
#include "support/gpu_test.h"
#include "support/primitive_scene.h"

namespace calotype::test {

std::shared_ptr<const TexelImage> randomImage(const ImageForm& form, RandomNumbers& random) {
    TexelImage image;
    image.width = form.width;
    image.height = form.height;
    image.isEncoded = form.isEncoded;
    for (size_t i = 0; i < 4 * image.texelCount(); ++i)
        if (form.holdsBytes)
            image.bytes.push_back(static_cast<uint8_t>(random.below(256)));
        else
            image.floats.push_back((form.isEncoded ? 1.0f : 20.0f) * random.deviceUnit());
    return std::make_shared<const TexelImage>(std::move(image));
}

Texture imageTexture(std::shared_ptr<const TexelImage> image, TextureWrap wrap,
                     TextureFilter filter) {
    Texture texture;
    texture.source = ImageTexture{std::move(image), wrap, filter, true};
    return texture;
}

const TexelImage& imageOf(const Texture& texture) {
    return *std::get<ImageTexture>(texture.source).image;
}

std::vector<Texture> variedTextures(const std::vector<ImageForm>& forms, RandomNumbers& random) {
    std::vector<Texture> textures;
    for (const ImageForm& form : forms) {
        const auto image = randomImage(form, random);
        for (const auto wrap : {TextureWrap::Repeat, TextureWrap::Clamp, TextureWrap::Mirror})
            for (const auto filter : {TextureFilter::Bilinear, TextureFilter::Nearest})
                textures.push_back(imageTexture(image, wrap, filter));
    }
    return textures;
}

PackedTextures::PackedTextures(std::vector<Texture> textures, bool isCutOut)
    : textures_(std::move(textures)) {
    TexturePacker packer(textures_);
    for (uint32_t i = 0; i < textures_.size(); ++i)
        EXPECT_EQ(packer.add(i, isCutOut), i);
    scene_.textures = packer.takePacked();
    scene_.texelRows = packer.takeTexelRows();
}

std::vector<glm::vec4>
PackedTextures::read(const std::vector<shared::TestTextureRead>& reads) const {
    const PrimitiveScene scene(scene_);
    const SceneBuffers buffers(testDevice(), scene.packed());
    return runKernel<glm::vec4>(kTextureReadSpirv, reads, buffers.bindings(), kTestInputBinding);
}

} // namespace calotype::test
