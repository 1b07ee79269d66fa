// Textures as the kernels read them, packed as the program packs them, against the oracle.
//
// A position of the source is known to the rounding of its coordinates only, so a color is right if
// the oracle gives it somewhere within that rounding: scale and offset take two operations, unless
// they are 1 and 0, and wrapping and multiplying by the size one each on numbers up to 1.
#include <cmath>
#include <memory>

#include "gpu/kernels/test_structs.h"
#include "gpu/primitive_scene.h"
#include "kernels/linear_from_srgb.spv.h"
#include "kernels/texture_read.spv.h"
#include "pack/pack_textures.h"
#include "render/scene_buffers.h"
#include "support/gpu_test.h"
#include "support/oracle_texture.h"
#include "support/random_numbers.h"

namespace calotype::test {
namespace {

constexpr double kRoundoffOfFloat = 0x1p-23;
/// Of linearFromSrgb, as it states, and of the arithmetic around it.
constexpr double kDecodingError = 1.5e-6;

struct ImageForm {
    uint32_t width;
    uint32_t height;
    bool holdsBytes;
    bool isEncoded;
};

std::shared_ptr<const TexelImage> randomImage(const ImageForm& form, RandomNumbers& random) {
    TexelImage image;
    image.width = form.width;
    image.height = form.height;
    image.isEncoded = form.isEncoded;
    for (size_t i = 0; i < 4 * image.texelCount(); ++i) {
        if (form.holdsBytes)
            image.bytes.push_back(static_cast<uint8_t>(random.below(256)));
        else
            image.floats.push_back((form.isEncoded ? 1.0f : 20.0f) * random.deviceUnit());
    }
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

/// Every way to read each of some images, which two textures and more therefore share.
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

/// Sizes from one texel to the largest side, in every form; rows of the packed texels are not full
/// for most of them.
std::vector<ImageForm> variedForms() {
    std::vector<ImageForm> forms;
    const std::pair<uint32_t, uint32_t> sizes[] = {{1, 1}, {1, 7}, {5, 3}, {16, 16}, {16384, 1}};
    for (const auto& [width, height] : sizes)
        for (const bool holdsBytes : {true, false})
            for (const bool isEncoded : {true, false})
                forms.push_back({width, height, holdsBytes, isEncoded});
    return forms;
}

/// Textures packed together, each under the index that it has in the list.
class PackedTextures {
public:
    explicit PackedTextures(std::vector<Texture> textures) : textures_(std::move(textures)) {
        TexturePacker packer(textures_);
        for (uint32_t i = 0; i < textures_.size(); ++i)
            EXPECT_EQ(packer.add(i), i);
        scene_.textures = packer.takePacked();
        scene_.texelRows = packer.takeTexelRows();
    }

    std::vector<glm::vec4> read(const std::vector<gpu::TestTextureRead>& reads) const {
        const PrimitiveScene scene(scene_);
        const SceneBuffers buffers(testDevice(), scene.packed());
        return runKernel<glm::vec4>(kTextureReadSpirv, reads, buffers.bindings(),
                                    kTestInputBinding);
    }

    const std::vector<Texture>& textures() const { return textures_; }
    size_t rowCount() const { return scene_.texelRows.size(); }

private:
    std::vector<Texture> textures_;
    GpuScene scene_;
};

/// A position of the source, and by how much float may be off it.
struct UncertainPosition {
    glm::dvec2 position;
    glm::dvec2 error;
};

UncertainPosition sourcePosition(const Texture& texture, const glm::vec2& uv) {
    const glm::dvec2 scaled = glm::dvec2(uv) * texture.scale;
    const glm::dvec2 position = scaled + texture.offset;
    const bool isAsGiven = texture.scale == glm::dvec2(1.0) && texture.offset == glm::dvec2(0.0);
    const glm::dvec2 operands = isAsGiven ? glm::dvec2(0.0) : glm::abs(scaled) + glm::abs(position);
    return {position, kRoundoffOfFloat * (2.0 + operands)};
}

/// Coordinates near x to which a color may belong: the ends, and the texel centre between them,
/// where a bilinear filter bends.
std::array<double, 3> candidates(double x, double error, double count) {
    const double center = (std::floor(x * count) + 0.5) / count;
    return {x - error, std::clamp(center, x - error, x + error), x + error};
}

/// Whether a color is the texture's somewhere within the error of the position.
testing::AssertionResult isRead(const Texture& texture, const UncertainPosition& at, bool decode,
                                const glm::vec4& color) {
    const auto* image = std::get_if<ImageTexture>(&texture.source);
    const glm::dvec2 size =
        image ? glm::dvec2(imageOf(texture).width, imageOf(texture).height) : glm::dvec2(1.0);
    glm::dvec4 least(1e300);
    glm::dvec4 greatest(-1e300);
    for (const double x : candidates(at.position.x, at.error.x, size.x))
        for (const double y : candidates(at.position.y, at.error.y, size.y)) {
            const glm::dvec4 value = oracleTexture(texture, {x, y}, decode);
            least = glm::min(least, value);
            greatest = glm::max(greatest, value);
        }
    for (int channel = 0; channel < 4; ++channel) {
        const double rounding =
            (6.0 * kRoundoffOfFloat + (decode && channel < 3 ? kDecodingError : 0.0)) *
            greatest[channel];
        if (!(color[channel] >= least[channel] - rounding &&
              color[channel] <= greatest[channel] + rounding))
            return testing::AssertionFailure()
                   << "channel " << channel << " is " << color[channel] << ", not from "
                   << least[channel] << " to " << greatest[channel] << ", at (" << at.position.x
                   << ", " << at.position.y << ") of " << size.x << " x " << size.y;
    }
    return testing::AssertionSuccess();
}

/// Coordinates along one axis of n texels: centres, edges, beside both, and outside.
double coordinate(uint32_t n, RandomNumbers& random) {
    const double cell = random.below(n + 1);
    switch (random.below(6)) {
    case 0:
        return (cell + 0.5) / n;
    case 1:
        return cell / n;
    case 2:
        return cell / n + random.between(-1e-3, 1e-3);
    case 3:
        return random.sign() * random.powerOfTen(-9.0, -1.0) + (random.coin() ? 1.0 : 0.0);
    case 4:
        return random.between(-4.0, 5.0);
    default:
        return random.unit();
    }
}

class TextureRead : public GpuTest {
protected:
    /// Reads each texture at coordinates of the test's choice, `count` times, decoded or not. What
    /// is known of a position to less than a quarter of a texel only is left out.
    template <typename Coordinates>
    void expectAsOracle(const PackedTextures& packed, int count, const Coordinates& uvFor) {
        RandomNumbers random(101);
        std::vector<gpu::TestTextureRead> reads;
        for (uint32_t i = 0; i < packed.textures().size(); ++i)
            for (int k = 0; k < count; ++k)
                reads.push_back({uvFor(packed.textures()[i], random), i, random.below(2)});
        const auto colors = packed.read(reads);
        size_t compared = 0;
        for (size_t i = 0; i < reads.size(); ++i) {
            const Texture& texture = packed.textures()[reads[i].index];
            const UncertainPosition at = sourcePosition(texture, reads[i].uv);
            const bool isImage = std::holds_alternative<ImageTexture>(texture.source);
            const double texels = isImage ? imageOf(texture).width + imageOf(texture).height : 1.0;
            if (std::max(at.error.x, at.error.y) * texels > 0.25)
                continue;
            ++compared;
            ASSERT_TRUE(isRead(texture, at, reads[i].decode != 0, colors[i]))
                << "texture " << reads[i].index << ", read " << i;
        }
        EXPECT_GT(compared, reads.size() / 2);
    }
};

glm::vec2 nearTheImage(const Texture& texture, RandomNumbers& random) {
    const TexelImage& image = imageOf(texture);
    return {coordinate(image.width, random), coordinate(image.height, random)};
}

TEST_F(TextureRead, IsTheOraclesNearTheImage) {
    RandomNumbers random(102);
    expectAsOracle(PackedTextures(variedTextures(variedForms(), random)), 500, nearTheImage);
}

TEST_F(TextureRead, IsTheOraclesFarFromTheImage) {
    RandomNumbers random(103);
    expectAsOracle(PackedTextures(variedTextures(variedForms(), random)), 300,
                   [](const Texture&, RandomNumbers& numbers) {
                       const double far = numbers.coin() ? 1e3 : 1e6;
                       const glm::dvec2 center(far * numbers.sign(), far * numbers.sign());
                       return glm::vec2(center + glm::dvec2(numbers.unit(), numbers.unit()));
                   });
}

TEST_F(TextureRead, AppliesScaleAndOffset) {
    RandomNumbers random(104);
    auto textures = variedTextures({{5, 3, true, true}, {16, 16, false, false}}, random);
    for (Texture& texture : textures) {
        // Numbers of few bits, which float holds as they are.
        texture.scale = {random.sign() * (1 + random.below(64)) / 8.0, 1 + random.below(8)};
        texture.offset = {random.sign() * random.below(64) / 16.0, random.below(64) / 16.0};
    }
    const PackedTextures packed(textures);
    expectAsOracle(packed, 1000, nearTheImage);
    expectAsOracle(packed, 1000, [](const Texture&, RandomNumbers& numbers) {
        return glm::vec2(numbers.between(-1e3, 1e3), numbers.between(-1e3, 1e3));
    });
}

// Sizes whose texel centres float holds: no weight of a neighbour comes in.
TEST_F(TextureRead, IsTheTexelItselfAtItsCentre) {
    RandomNumbers random(105);
    const PackedTextures packed(variedTextures({{1, 1, true, false},
                                                {16, 16, true, false},
                                                {16, 16, false, false},
                                                {16384, 1, true, true}},
                                               random));
    for (uint32_t index = 0; index < packed.textures().size(); ++index) {
        const Texture& texture = packed.textures()[index];
        const TexelImage& image = imageOf(texture);
        std::vector<gpu::TestTextureRead> reads;
        for (uint32_t row = 0; row < image.height; ++row)
            for (uint32_t column = 0; column < image.width; ++column)
                reads.push_back(
                    {{(column + 0.5) / image.width, 1.0 - (row + 0.5) / image.height}, index, 0});
        const auto colors = packed.read(reads);
        for (size_t texel = 0; texel < reads.size(); ++texel)
            for (int channel = 0; channel < 4; ++channel) {
                const size_t i = 4 * texel + channel;
                if (image.holdsBytes())
                    ASSERT_NEAR(colors[texel][channel], image.bytes[i] / 255.0, kRoundoffOfFloat);
                else
                    ASSERT_EQ(colors[texel][channel], image.floats[i]);
            }
    }
}

TEST_F(TextureRead, DecodesNeitherAlphaNorWhatIsNoColor) {
    TexelImage image;
    image.width = image.height = 1;
    image.isEncoded = true;
    image.bytes = {128, 64, 255, 128};
    Texture color = imageTexture(std::make_shared<const TexelImage>(image), TextureWrap::Repeat,
                                 TextureFilter::Bilinear);
    Texture linear = color;
    std::get<ImageTexture>(linear.source).decodesColor = false;
    const auto colors =
        PackedTextures({color, linear}).read({{{}, 0, 1}, {{}, 0, 0}, {{}, 1, 1}, {{}, 1, 0}});
    EXPECT_NEAR(colors[0].r, 0.2158605, 1e-6);
    EXPECT_NEAR(colors[0].g, 0.0512695, 1e-6);
    for (size_t i = 0; i < colors.size(); ++i) {
        EXPECT_FLOAT_EQ(colors[i].a, 128.0f / 255.0f);
        EXPECT_NEAR(colors[i].b, 1.0f, i == 0 ? kDecodingError : 0.0);
        if (i > 0) {
            EXPECT_FLOAT_EQ(colors[i].r, 128.0f / 255.0f);
        }
    }
}

TEST_F(TextureRead, AlternatesTheColorsOfACheckerOnBothSidesOfZero) {
    RandomNumbers random(106);
    std::vector<Texture> textures;
    for (const glm::dvec2& scale : {glm::dvec2(1.0), glm::dvec2(8.0, 4.0), glm::dvec2(-3.0, 0.5)}) {
        Texture texture;
        texture.source = CheckerTexture{{glm::dvec3(0.8, 0.5, 0.2), glm::dvec3(0.1, 0.3, 0.7)}};
        texture.scale = scale;
        texture.offset = {0.25 * random.below(8), -0.25 * random.below(8)};
        textures.push_back(texture);
    }
    const PackedTextures packed(textures);
    for (const double reach : {2.0, 100.0, 1e4})
        expectAsOracle(packed, 2000, [&](const Texture&, RandomNumbers& numbers) {
            return glm::vec2(numbers.between(-reach, reach), numbers.between(-reach, reach));
        });
}

TEST_F(TextureRead, KeepsEachImageOnce) {
    RandomNumbers random(107);
    const PackedTextures packed(variedTextures({{5, 3, true, true}, {1, 7, false, false}}, random));
    EXPECT_EQ(packed.textures().size(), 12u);
    EXPECT_EQ(packed.rowCount(), 4u + 7u); // 15 texels at four a row, 7 at one a row
}

// What a file may say: coordinates beyond all reason are some texel, or not a number; never a read
// outside the image.
TEST_F(TextureRead, SurvivesCoordinatesWithoutBound) {
    RandomNumbers random(108);
    const PackedTextures packed(
        variedTextures({{5, 3, true, true}, {16, 16, false, false}}, random));
    std::vector<gpu::TestTextureRead> reads;
    for (uint32_t i = 0; i < packed.textures().size(); ++i)
        for (const float u : {-3e38f, -1e30f, -1e10f, 1e10f, 1e30f, 3e38f})
            reads.push_back({{u, 0.5f}, i, 0});
    for (const glm::vec4& color : packed.read(reads))
        for (int channel = 0; channel < 4; ++channel) {
            EXPECT_GE(color[channel], 0.0f);
            EXPECT_LE(color[channel], 20.0f);
        }
}

class LinearFromSrgb : public GpuTest {};

TEST_F(LinearFromSrgb, IsTheStandardsForEveryByteAndBetween) {
    std::vector<float> encoded;
    for (int byte = 0; byte < 256; ++byte)
        encoded.push_back(static_cast<float>(byte) / 255.0f);
    for (int word = 0; word < 65536; ++word)
        encoded.push_back(static_cast<float>(word) / 65535.0f);
    const auto linear = runKernel<float>(kLinearFromSrgbSpirv, encoded);
    double worst = 0.0;
    for (size_t i = 0; i < encoded.size(); ++i) {
        const double wanted = oracleLinearFromSrgb(encoded[i]);
        worst = std::max(worst, std::abs(linear[i] - wanted) / std::max(wanted, 1e-30));
    }
    RecordProperty("worstTimes1e9", std::to_string(worst * 1e9));
    EXPECT_LT(worst, kDecodingError);
    EXPECT_EQ(linear[0], 0.0f);
}

} // namespace
} // namespace calotype::test
