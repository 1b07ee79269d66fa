// The input is an OBJ and its MTL in one: it may name itself ("mtllib model.obj"), since the two
// formats have no statement in common.

#include "harness.h"
#include "read/load.h"
#include "scene_invariants.h"
#include "small_assets.h"

namespace calotype::fuzz {
namespace {

class Folder : public ScratchFolder {
public:
    Folder() { writeSmallAssets(*this); }
};

} // namespace
} // namespace calotype::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace calotype::fuzz;
    static const Folder folder;
    const std::string path = folder.write("model.obj", textOf(data, size));
    calotype::LoadOptions options;
    options.missingTextures = calotype::MissingTextures::Warn;
    readOrRefuse([&] { checkScene(calotype::loadScene(path, options)); });
    return 0;
}
