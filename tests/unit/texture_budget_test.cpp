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

struct MapUse {
    std::string mtl;
    int onHost;   ///< MiB
    int onDevice; ///< MiB
};

// Sizes are 4 side^2 bytes: 64, 16 and 4 MiB.
TEST_F(TextureBudgetTest, OnlyMapsThatTheMaterialUsesAreCounted) {
    sceneOfLargeImages(files_);
    files_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    nlohmann::json scene = plainScene();
    scene["shapes"].push_back({{"type", "mesh"}, {"file", "m.obj"}});
    const std::string blender = "# Blender 4.2.0 MTL File: 'a.blend'\n";
    const std::string name = "newmtl a\n";
    const std::string mapKd = "map_Kd 4096.png\n";
    const std::vector<MapUse> uses = {
        {name + mapKd, 64, 64},
        {name + mapKd + "illum 7\nNi 1.5\n", 64, 0},                  // glass: read for its alpha
        {name + mapKd + "illum 7\nNi 1.5\nmap_d 2048.png\n", 80, 80}, // with holes, so no glass
        {name + mapKd + "illum 7\nNi 1.5\nKe 1\n", 64, 64},
        {name + mapKd + "illum 7\nNi 1.5\nPm 1\n", 64, 64},
        {name + mapKd + "illum 7\nNi 1.5\nmap_Pr 2048.png\n", 64, 0},
        {name + "Pr 1\nmap_Pr 2048.png\nbump 4096.png\n", 80, 80},
        {name + "norm 2048.png\nbump 4096.png\n", 16, 16},
        {name + "Kd 0\nKs 1\nillum 3\nmap_Pr 4096.png\nmap_Pm 2048.png\n", 16, 0},
        {name + "map_Ke 2048.png\nmap_Pm 1024.png\n", 20, 0},
        {name + "Ke 0\nmap_Ke 4096.png\nmap_Pm 1024.png\n", 4, 0},
        {name + "Pr 1\nmap_Ks 4096.png\nmap_Pr 2048.png\n", 16, 16}, // map_Ks of Blender alone
        {blender + name + "map_Ns 2048.png\nmap_Ks 4096.png\n", 80, 80},
        {blender + name + "illum 3\nKa 1\nmap_Ns 2048.png\nmap_Ks 4096.png\n", 16, 16}, // metal
        {blender + name + "Pm 1\nmap_Ns 2048.png\nmap_Ks 4096.png\nmap_Pr 1024.png\n", 4, 4},
        {blender + name + "Pr 0\nTf 1\nNi 1.5\n" + mapKd + "map_Ks 2048.png\n", 64, 0},
        {blender + name + "Ks 1 0 0\nmap_Ns 2048.png\nmap_Ks 4096.png\nmap_Kd 1024.png\n", 4, 4},
    };
    for (const MapUse& use : uses) {
        SCOPED_TRACE(use.mtl);
        files_.write("m.mtl", use.mtl);
        LoadOptions options;
        options.hostMemory = 0;
        expectContains(messageOf<Error>(scene, options),
                       "take " + std::to_string(use.onHost) + " MiB of this machine's memory");
        if (use.onDevice == 0)
            continue;
        options.hostMemory = uint64_t{1} << 40;
        options.deviceTextureMemory = [] { return DeviceTextureMemory{0, "no GPU", false}; };
        expectContains(messageOf<GpuError>(scene, options),
                       "take " + std::to_string(use.onDevice) + " MiB on the device");
    }
}

// Glass of many large maps is no reason to refuse a model: the device gets none of them.
TEST_F(TextureBudgetTest, ImagesOfGlassNeedNoRoomOnTheDevice) {
    sceneOfLargeImages(files_);
    files_.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    files_.write("m.mtl", "newmtl a\nillum 7\nNi 1.5\nmap_Kd 4096.png\n");
    nlohmann::json scene = plainScene();
    scene["shapes"].push_back({{"type", "mesh"}, {"file", "m.obj"}});
    LoadOptions options;
    options.hostMemory = uint64_t{64} << 20;
    options.deviceTextureMemory = [] { return DeviceTextureMemory{0, "no GPU", true}; };
    expectContains(messageOf<Error>(scene, options), "corrupt"); // it has no texels
}

} // namespace
} // namespace calotype::test
