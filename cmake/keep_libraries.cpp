/// Part of every program that is built with sanitizers. The Vulkan loader closes the driver when an
/// instance is destroyed. What the driver still holds in its own variables, LeakSanitizer would
/// then report as lost, from an unknown module. So libraries stay open until the program ends.
extern "C" int dlclose(void* /*library*/) { return 0; }
