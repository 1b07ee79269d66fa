#include "support/gpu_test.h"

#include <cstdlib>

namespace calotype::test {
namespace {

const Instance& testInstance() {
    static const Instance instance(true);
    return instance;
}

} // namespace

const Device& testDevice() {
    const char* wish = std::getenv("CALOTYPE_DEVICE");
    static const Device device(testInstance(), wish ? wish : "", "CALOTYPE_DEVICE");
    return device;
}

void GpuTest::TearDown() {
    for (const std::string& message : testInstance().validationMessages())
        ADD_FAILURE() << "validation layer: " << message;
}

} // namespace calotype::test
