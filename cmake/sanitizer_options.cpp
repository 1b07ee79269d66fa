/// Part of every program that is built with sanitizers, so that LeakSanitizer judges our memory and
/// not that of Mesa's lavapipe.

/// The Vulkan loader closes the driver when an instance is destroyed. What the driver still holds
/// in its own variables would then count as lost, from an unknown module. So libraries stay open
/// until the program ends.
extern "C" int dlclose(void* /*library*/) { return 0; }

/// After a device is destroyed, lavapipe keeps the code of some pipelines in cycles of pointers.
/// Pipelines that we do not destroy are found by the validation layers.
extern "C" const char* __lsan_default_suppressions() { return "leak:libvulkan_lvp.so\n"; }
