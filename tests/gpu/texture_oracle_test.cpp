// Textures as the kernels read them against the oracle.
//
// A position of the source is known to the rounding of its coordinates only, so a color is right if
// the oracle gives it somewhere within that rounding: scale and offset take two operations, unless
// they are 1 and 0, and wrapping and multiplying by the size one each on numbers up to 1.
#include <array>
#include <cmath>

#include "support/gpu_test.h"
#include "support/oracle_texture.h"
#include "support/packed_textures.h"

namespace calotype::test {
namespace {

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

using Oracle = glm::dvec4 (*)(const Texture& texture, const glm::dvec2& position, bool decode);

glm::dvec4 oracleCutOut(const Texture& texture, const glm::dvec2& position, bool decode) {
    return {oracleCutOutColor(texture, position, decode),
            oracleTexture(texture, position, decode).w};
}

/// Whether a color is the oracle's somewhere within the error of the position. A mean weighted by
/// alpha is, like one without, monotonic in each coordinate between texel centres.
testing::AssertionResult isRead(Oracle oracle, const Texture& texture, const UncertainPosition& at,
                                bool decode, const glm::vec4& color) {
    const auto* image = std::get_if<ImageTexture>(&texture.source);
    const glm::dvec2 size =
        image ? glm::dvec2(imageOf(texture).width, imageOf(texture).height) : glm::dvec2(1.0);
    glm::dvec4 least(1e300);
    glm::dvec4 greatest(-1e300);
    for (const double x : candidates(at.position.x, at.error.x, size.x))
        for (const double y : candidates(at.position.y, at.error.y, size.y)) {
            const glm::dvec4 value = oracle(texture, {x, y}, decode);
            least = glm::min(least, value);
            greatest = glm::max(greatest, value);
        }
    for (int channel = 0; channel < 4; ++channel) {
        // Eight roundings of a weighted sum, and seven of its weights, by which it is divided.
        const double roundings = oracle == oracleTexture ? 6.0 : 16.0;
        const double rounding =
            (roundings * kRoundoffOfFloat + (decode && channel < 3 ? kDecodingError : 0.0)) *
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

class TextureOracleTest : public GpuTest {
protected:
    /// Reads each texture at coordinates of the test's choice, `count` times, decoded or not. What
    /// is known of a position to less than a quarter of a texel only is left out.
    template <typename Coordinates>
    void expectAsOracle(const PackedTextures& packed, int count, const Coordinates& uvFor,
                        Oracle oracle = oracleTexture) {
        RandomNumbers random(101);
        std::vector<shared::TestTextureRead> reads;
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
            ASSERT_TRUE(isRead(oracle, texture, at, reads[i].decode != 0, colors[i]))
                << "texture " << reads[i].index << ", read " << i;
        }
        EXPECT_GT(compared, reads.size() / 2);
    }
};

glm::vec2 nearTheImage(const Texture& texture, RandomNumbers& random) {
    const TexelImage& image = imageOf(texture);
    return {coordinate(image.width, random), coordinate(image.height, random)};
}

TEST_F(TextureOracleTest, AgreesNearTheImage) {
    RandomNumbers random(102);
    expectAsOracle(PackedTextures(variedTextures(variedForms(), random)), 500, nearTheImage);
}

// A third of the texels are transparent.
TEST_F(TextureOracleTest, WeighsColoursOfCutOutsByAlpha) {
    RandomNumbers random(109);
    std::vector<Texture> textures = variedTextures(variedForms(), random);
    for (Texture& texture : textures) {
        auto image = std::make_shared<TexelImage>(imageOf(texture));
        for (size_t i = 0; i < image->texelCount(); ++i)
            if (random.below(3) == 0)
                image->holdsBytes() ? image->bytes[4 * i + 3] = 0 : image->floats[4 * i + 3] = 0.0f;
        std::get<ImageTexture>(texture.source).image = image;
    }
    expectAsOracle(PackedTextures(textures, true), 300, nearTheImage, oracleCutOut);
}

TEST_F(TextureOracleTest, AgreesFarFromTheImage) {
    RandomNumbers random(103);
    expectAsOracle(PackedTextures(variedTextures(variedForms(), random)), 300,
                   [](const Texture&, RandomNumbers& numbers) {
                       const double far = numbers.coin() ? 1e3 : 1e6;
                       const glm::dvec2 center(far * numbers.sign(), far * numbers.sign());
                       return glm::vec2(center + glm::dvec2(numbers.unit(), numbers.unit()));
                   });
}

TEST_F(TextureOracleTest, AppliesScaleAndOffset) {
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

TEST_F(TextureOracleTest, AlternatesTheColorsOfACheckerOnBothSidesOfZero) {
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

} // namespace
} // namespace calotype::test
