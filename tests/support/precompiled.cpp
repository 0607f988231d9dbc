// Catch2's header is precompiled for this file, and taken by every test: CMake makes one only
// where a source of the same target takes it, and main.cpp cannot.
#include "tests/support/catch.hpp"
