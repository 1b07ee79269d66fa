#include "support/gpu_test.h"

#include <cstdlib>

namespace calotype::test {
namespace {

const Instance& testInstance() {
    static const Instance instance = [] {
        setenv("CALOTYPE_VALIDATION", "1", 1);
        return Instance();
    }();
    return instance;
}

} // namespace

const Device& testDevice() {
    static const Device device(testInstance(), "");
    return device;
}

void GpuTest::TearDown() {
    for (const std::string& message : testInstance().validationMessages())
        ADD_FAILURE() << "validation layer: " << message;
}

} // namespace calotype::test
