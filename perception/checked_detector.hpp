#pragma once

#include <memory>
#include <string>

#include "perception/place_detector.hpp"

namespace asterism {

/// A detector that is another one, stopped at the first visit that breaks one of the laws of
/// perception/detector_laws.hpp: then observe and finish throw PluginError
/// "title: visit 3: found ...; expected ...".
///
/// @param title  names the detector in messages
std::unique_ptr<PlaceDetector> checked(std::unique_ptr<PlaceDetector> detector, std::string title);

}  // namespace asterism
