#include "perception/checked_detector.hpp"

#include <utility>

#include "perception/detector_laws.hpp"
#include "perception/plugin_error.hpp"

namespace asterism {
namespace {

class CheckedDetector : public PlaceDetector {
 public:
  CheckedDetector(std::unique_ptr<PlaceDetector> detector, std::string title)
      : detector_(std::move(detector)), title_(std::move(title)) {}

  std::string_view name() const noexcept override { return detector_->name(); }

  std::optional<DetectedVisit> observe(const Scan& scan) override {
    laws_.fed(scan);
    return lawful(detector_->observe(scan));
  }

  std::optional<DetectedVisit> finish() override { return lawful(detector_->finish()); }

 private:
  std::optional<DetectedVisit> lawful(std::optional<DetectedVisit> seen) {
    if (seen)
      if (const auto broken = laws_.broken_by(*seen); !broken.empty())
        throw plugin_error(title_, broken.front());
    return seen;
  }

  std::unique_ptr<PlaceDetector> detector_;
  std::string title_;
  DetectorLaws laws_;
};

}  // namespace

std::unique_ptr<PlaceDetector> checked(std::unique_ptr<PlaceDetector> detector, std::string title) {
  return std::make_unique<CheckedDetector>(std::move(detector), std::move(title));
}

}  // namespace asterism
