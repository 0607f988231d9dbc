#include "perception/plugin.hpp"

namespace {

using namespace asterism;

/// Tells of a visit at every scan, each with the scan of the first.
class LawlessDetector : public PlaceDetector {
  std::string_view name() const noexcept override { return "lawless"; }
  std::optional<DetectedVisit> observe(const Scan&) override {
    return DetectedVisit{
        {.star = Star::parse("a+1 a-1"), .entered_by = 0, .left_by = 1, .scans = {{0, 0}}}};
  }
  std::optional<DetectedVisit> finish() override { return std::nullopt; }
};

}  // namespace

const DetectorPlugin asterism_detector_plugin{.create = []() -> std::unique_ptr<PlaceDetector> {
  return std::make_unique<LawlessDetector>();
}};
