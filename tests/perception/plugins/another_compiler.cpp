#include "perception/plugin.hpp"

const asterism::DetectorPlugin asterism_detector_plugin{.compiler = nullptr};
