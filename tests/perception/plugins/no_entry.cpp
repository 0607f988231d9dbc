// A library, but of no detector.
extern "C" int asterism_detector() { return 1; }
