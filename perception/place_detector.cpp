#include "perception/place_detector.hpp"
