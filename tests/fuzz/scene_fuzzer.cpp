// The input is a scene file beside a few small assets.

#include <nlohmann/json.hpp>

#include "harness.h"
#include "read/load.h"
#include "scene_invariants.h"
#include "small_assets.h"

namespace calotype::fuzz {
namespace {

/// Whether any "subdivide" makes more than 4^4 triangles of each: the format allows so many
/// that time and memory would be spent on them alone.
bool subdividesFinely(std::string_view text) {
    constexpr double kMostSubdivisions = 4.0;
    using nlohmann::json;
    bool atSubdivide = false;
    bool finely = false;
    const auto look = [&](int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::value && atSubdivide && parsed.is_number())
            finely = finely || parsed.get<double>() > kMostSubdivisions;
        atSubdivide = event == json::parse_event_t::key && parsed == "subdivide";
        return true;
    };
    constexpr bool kThrows = false;
    constexpr bool kIgnoresComments = true;
    (void)json::parse(text, look, kThrows, kIgnoresComments);
    return finely;
}

class Folder : public ScratchFolder {
public:
    Folder() { writeSmallAssets(*this); }
};

} // namespace
} // namespace calotype::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace calotype::fuzz;
    const std::string_view text = textOf(data, size);
    if (subdividesFinely(text))
        return 0;
    static const Folder folder;
    const std::string path = folder.write("scene.json", text);
    readOrRefuse([&] { checkScene(calotype::loadScene(path)); });
    return 0;
}
