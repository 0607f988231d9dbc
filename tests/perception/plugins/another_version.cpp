#include "perception/plugin.hpp"

const asterism::DetectorPlugin asterism_detector_plugin{.version = "0.0.9\n"};
