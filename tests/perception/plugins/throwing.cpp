#include <stdexcept>

#include "perception/plugin.hpp"

namespace {

using namespace asterism;

/// Throws an exception of its own at scan 3, and something else at the end.
class ThrowingDetector : public PlaceDetector {
  struct Failure : std::exception {
    const char* what() const noexcept override { return "found smoke;\nexpected none"; }
  };

  std::string_view name() const noexcept override { return "throwing"; }
  std::optional<DetectedVisit> observe(const Scan& scan) override {
    if (scan.number == 3) throw Failure();
    return std::nullopt;
  }
  std::optional<DetectedVisit> finish() override { throw 42; }
};

}  // namespace

const DetectorPlugin asterism_detector_plugin{.create = []() -> std::unique_ptr<PlaceDetector> {
  return std::make_unique<ThrowingDetector>();
}};
