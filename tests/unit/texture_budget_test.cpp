// Images whose sizes exceed the memory are refused by their headers.

#include <gtest/gtest.h>

#include "image/texel_image_size.h"
#include "support/image_files.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

class TextureBudgetTest : public testing::Test {
protected:
    uint64_t bytesOf(const std::string& name, const std::string& file) {
        const auto size = sizeOfTexelImage(files_.write(name, file));
        return size ? size->bytes() : 0;
    }

    /// The message of the error that loading throws.
    template <typename ErrorType>
    std::string messageOf(const nlohmann::json& scene, const LoadOptions& options) {
        try {
            files_.load(scene, options);
        } catch (const ErrorType& error) {
            return error.what();
        }
        return "";
    }

    SceneFiles files_;
};

void expectContains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST_F(TextureBudgetTest, HeadersTellTheSizeOfEveryFormat) {
    const std::vector<Rgba8> texels(15, Rgba8{1, 2, 3, 255});
    std::string jpeg;
    std::string bmp;
    std::string tga;
    stbi_write_jpg_to_func(appendTo, &jpeg, 5, 3, 4, texels.data(), 90);
    stbi_write_bmp_to_func(appendTo, &bmp, 5, 3, 4, texels.data());
    stbi_write_tga_to_func(appendTo, &tga, 5, 3, 4, texels.data());
    // More than a buffer's worth of other data before the size.
    std::string segments;
    for (int i = 0; i < 3; ++i)
        segments += std::string("\xff\xee\xff\xff") + std::string(65533, 'x');
    for (const std::string& file :
         {pngOf(5, 3, texels), jpeg, jpeg.substr(0, 2) + segments + jpeg.substr(2), bmp, tga})
        EXPECT_EQ(bytesOf("a", file), 5u * 3u * 4u);
    EXPECT_EQ(bytesOf("a", pngFile(5, 3, 16, 6, "")), 5u * 3u * 16u);
    EXPECT_EQ(bytesOf("a", "#?RADIANCE\n\n-Y 3 +X 5\n"), 5u * 3u * 16u);
    for (const char* file : {"", "DDS |....", "#?RADIANCE\n", "\x89PNG\r\n\x1a\n"})
        EXPECT_EQ(bytesOf("a", file), 0u) << file;
    EXPECT_FALSE(sizeOfTexelImage(files_.path("none.png")));
    EXPECT_FALSE(sizeOfTexelImage(files_.path("")));
}

/// Three images of which only headers exist: 64, 16 and 4 MiB.
nlohmann::json sceneOfLargeImages(const SceneFiles& files) {
    nlohmann::json scene = plainScene();
    for (const uint32_t side : {4096u, 2048u, 1024u}) {
        const std::string name = std::to_string(side);
        files.write(name + ".png", pngFile(side, side, 8, 6, ""));
        scene["textures"][name] = {{"type", "image"}, {"file", name + ".png"}};
    }
    scene["materials"]["wall"]["color"] = "4096";
    scene["materials"]["tile"] = {{"type", "diffuse"}, {"color", "2048"}};
    return scene;
}

TEST_F(TextureBudgetTest, DeviceIsAskedBeforeAnythingIsDecoded) {
    const nlohmann::json scene = sceneOfLargeImages(files_);
    LoadOptions options;
    options.deviceTextureMemory = [] {
        return DeviceTextureMemory{uint64_t{79} << 20, "a small GPU", false};
    };
    // The third image is on no material, so it is not uploaded.
    const std::string message = messageOf<GpuError>(scene, options);
    expectContains(message, "take 80 MiB on the device, and 'a small GPU' has room for 79 MiB");
    expectContains(message, "the largest of 3 files are \"4096.png\" (4096 x 4096, 64 MiB), "
                            "\"2048.png\" (2048 x 2048, 16 MiB), \"1024.png\"");
    options.deviceTextureMemory = [] {
        return DeviceTextureMemory{uint64_t{80} << 20, "a GPU", false};
    };
    expectContains(messageOf<SceneError>(scene, options), "corrupt"); // it has no texels
}

TEST_F(TextureBudgetTest, HostNeedsRoomForAllOfThem) {
    const nlohmann::json scene = sceneOfLargeImages(files_);
    LoadOptions options;
    options.hostMemory = uint64_t{83} << 20;
    expectContains(messageOf<Error>(scene, options),
                   "take 84 MiB of this machine's memory, and 83 MiB are available");
    options.hostMemory = uint64_t{84} << 20;
    expectContains(messageOf<Error>(scene, options), "corrupt");
    // A device that is a CPU has its copies there too.
    options.deviceTextureMemory = [] {
        return DeviceTextureMemory{uint64_t{1} << 30, "a CPU", true};
    };
    expectContains(messageOf<Error>(scene, options), "take 164 MiB of this machine's memory");
}

TEST_F(TextureBudgetTest, ImagesOfModelsAreCountedTogether) {
    sceneOfLargeImages(files_);
    files_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    files_.write("m.mtl", "newmtl a\nmap_Kd 1024.png\nmap_Ke 4096.png\nnewmtl b\nmap_Kd "
                          "2048.png\n");
    nlohmann::json scene = plainScene();
    scene["shapes"].push_back({{"type", "mesh"}, {"file", "m.obj"}});
    LoadOptions options;
    options.hostMemory = 0;
    // Material b is on no face.
    expectContains(messageOf<Error>(scene, options), "take 68 MiB");
}

} // namespace
} // namespace calotype::test
