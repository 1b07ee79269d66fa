// calotype render --aov cryptoObject,cryptoMaterial, read as the specification says, by nothing of
// Calotype.
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"

namespace calotype::test {
namespace {

/// The mattes of one layer of an EXR file, by name, row by row.
class Decoder {
public:
    Decoder(const std::string& path, const std::string& layer) : file_(path.c_str()) {
        const Imf::Header& header = file_.header();
        for (auto i = header.begin(); i != header.end(); ++i) {
            const std::string name = i.name();
            if (name.starts_with("cryptomatte/") && name.ends_with("/name") &&
                textOf(name) == layer)
                prefix_ = name.substr(0, name.size() - 4);
        }
        if (prefix_.empty())
            return;
        EXPECT_EQ(prefix_.size(), std::strlen("cryptomatte/1234567/"));
        EXPECT_EQ(textOf(prefix_ + "hash"), "MurmurHash3_32");
        EXPECT_EQ(textOf(prefix_ + "conversion"), "uint32_to_float32");
        const auto manifest = nlohmann::json::parse(textOf(prefix_ + "manifest"));
        for (const auto& [name, id] : manifest.items())
            ids_[name] = static_cast<uint32_t>(std::stoul(id.get<std::string>(), nullptr, 16));
        for (int level = 0;; ++level) {
            const std::string group = layer + "0" + std::to_string(level);
            if (!header.channels().findChannel((group + ".R").c_str()))
                break;
            for (const char* component : {".R", ".G", ".B", ".A"})
                levels_.push_back(read(group + component));
        }
    }

    bool isThere() const { return !prefix_.empty(); }
    size_t levels() const { return levels_.size() / 4; }
    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& [name, id] : ids_)
            names.push_back(name);
        return names;
    }

    std::vector<float> matte(const std::string& name) const {
        EXPECT_TRUE(ids_.contains(name)) << name;
        std::vector<float> sum(levels_.front().size());
        for (size_t pair = 0; pair < levels_.size(); pair += 2)
            for (size_t i = 0; i < sum.size(); ++i) {
                uint32_t bits = 0;
                std::memcpy(&bits, &levels_[pair][i], 4);
                sum[i] += bits == ids_.at(name) ? levels_[pair + 1][i] : 0.0f;
            }
        return sum;
    }

    std::vector<float> read(const std::string& channel) {
        const Imath::Box2i window = file_.header().dataWindow();
        const Imf::Channel* found = file_.header().channels().findChannel(channel.c_str());
        std::vector<float> values(static_cast<size_t>(window.max.x - window.min.x + 1) *
                                  (window.max.y - window.min.y + 1));
        if (!found) {
            ADD_FAILURE() << "no channel " << channel;
            return values;
        }
        EXPECT_EQ(found->type, Imf::FLOAT);
        Imf::FrameBuffer buffer;
        buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, values.data(), window));
        file_.setFrameBuffer(buffer);
        file_.readPixels(window.min.y, window.max.y);
        return values;
    }

private:
    std::string textOf(const std::string& attribute) const {
        const auto* text =
            file_.header().findTypedAttribute<Imf::StringAttribute>(attribute.c_str());
        return text ? text->value() : "";
    }

    Imf::InputFile file_;
    std::string prefix_;
    std::map<std::string, uint32_t> ids_;
    std::vector<std::vector<float>> levels_;
};

/// The small scene with a name for its floor.
std::string namedScene() {
    std::string text = kSmallScene;
    return text.insert(text.find("\"type\": \"quad\""), "\"name\": \"floor\", ");
}

class CryptomatteTest : public CliTest {
protected:
    CryptomatteTest() { scene_ = folder_.write("named.json", namedScene()); }

    std::string render(const std::string& name, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"render", scene_, "-q", "-o", folder_ / name};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = runProgram(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.errors;
        return folder_ / name;
    }
};

using Names = std::vector<std::string>;

TEST_F(CryptomatteTest, MattesOfObjectsAndMaterialsAreThere) {
    const std::string path = render("a.exr", {"--aov", "alpha,cryptoObject,cryptoMaterial"});
    Decoder objects(path, "CryptoObject");
    Decoder materials(path, "CryptoMaterial");
    ASSERT_TRUE(objects.isThere());
    ASSERT_TRUE(materials.isThere());
    EXPECT_EQ(objects.levels(), 3u);
    EXPECT_EQ(objects.names(), (Names{"floor", "light 0", "sphere 1"}));
    EXPECT_EQ(materials.names(), (Names{"grey", "light 0"}));
    const std::vector<float> ball = objects.matte("sphere 1");
    const std::vector<float> floor = objects.matte("floor");
    const std::vector<float> lamp = objects.matte("light 0");
    const std::vector<float> grey = materials.matte("grey");
    const std::vector<float> alpha = objects.read("alpha.A");
    EXPECT_EQ(ball[12 * 32 + 16], 1.0f);
    EXPECT_EQ(floor[23 * 32 + 16], 1.0f);
    size_t edges = 0;
    for (size_t i = 0; i < ball.size(); ++i) {
        // All are shares of the same 32 rays.
        EXPECT_FLOAT_EQ(ball[i] + floor[i], grey[i]);
        EXPECT_FLOAT_EQ(grey[i] + lamp[i], alpha[i]);
        edges += ball[i] > 0.0f && floor[i] > 0.0f ? 1 : 0;
    }
    EXPECT_GT(edges, 10u);
}

TEST_F(CryptomatteTest, OnlyWhereTheyAreWanted) {
    const std::string film = folder_ / "a.film";
    const std::string path =
        render("a.exr", {"--aov", "cryptoMaterial", "--spp", "16", "--film", film});
    EXPECT_FALSE(Decoder(path, "CryptoObject").isThere());
    EXPECT_TRUE(Decoder(path, "CryptoMaterial").isThere());
    const ProgramResult merged =
        runProgram({"merge", film, "-o", folder_ / "b.exr", "--aov", "cryptoObject"});
    expectFailure(merged, 2, "films hold samples of light alone");
}

// A crop has the same mattes, the reference nearly the same ones.
TEST_F(CryptomatteTest, CropsAndTheReferenceHaveThemToo) {
    const std::vector<float> all =
        Decoder(render("a.exr", {"--aov", "cryptoObject"}), "CryptoObject").matte("sphere 1");
    const std::vector<float> part =
        Decoder(render("b.exr", {"--aov", "cryptoObject", "--crop", "9,5,15,11"}), "CryptoObject")
            .matte("sphere 1");
    ASSERT_EQ(part.size(), 15u * 11u);
    for (size_t y = 0; y < 11; ++y)
        for (size_t x = 0; x < 15; ++x)
            EXPECT_EQ(part[15 * y + x], all[32 * (y + 5) + x + 9]);
    const std::vector<float> reference =
        Decoder(render("c.exr", {"--aov", "cryptoObject", "--device", "reference"}), "CryptoObject")
            .matte("sphere 1");
    size_t differing = 0;
    for (size_t i = 0; i < all.size(); ++i)
        differing += all[i] != reference[i] ? 1 : 0;
    // One ray of 5,000 may go another way by rounding.
    EXPECT_LE(differing, 32 * all.size() / 5000 + 1);
}

} // namespace
} // namespace calotype::test
