// Made for an Asterism whose entry point has grown: nothing but its first member can be read.
extern "C" {
[[gnu::visibility("default")]] extern const unsigned asterism_detector_plugin[1];
const unsigned asterism_detector_plugin[1] = {2};
}
