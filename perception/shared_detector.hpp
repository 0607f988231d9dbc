#pragma once

#include <memory>
#include <string>

#include "perception/place_detector.hpp"

namespace asterism {

/// The detector of a shared library (perception/plugin.hpp). It is held to the laws of
/// perception/detector_laws.hpp, and whatever it throws becomes a PluginError. The library stays
/// loaded as long as the detector is there.
///
/// @param file  always a file, never a name to look for in the system's folders
/// @throws PluginError "file: found ...; expected ..." if there is no such library, it exports no
///         detector, or it was built for another version of Asterism or with another compiler
std::unique_ptr<PlaceDetector> load_detector(const std::string& file);

}  // namespace asterism
