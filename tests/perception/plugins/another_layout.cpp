#include "perception/plugin.hpp"

const asterism::DetectorPlugin asterism_detector_plugin{.sizes = {1, 2}};
