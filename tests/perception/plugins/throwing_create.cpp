#include <stdexcept>

#include "perception/plugin.hpp"

const asterism::DetectorPlugin asterism_detector_plugin{
    .create = []() -> std::unique_ptr<asterism::PlaceDetector> {
      throw std::runtime_error("found no camera; expected one");
    }};
