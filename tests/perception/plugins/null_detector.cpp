#include "perception/plugin.hpp"

const asterism::DetectorPlugin asterism_detector_plugin{
    .create = [] { return std::unique_ptr<asterism::PlaceDetector>(); }};
