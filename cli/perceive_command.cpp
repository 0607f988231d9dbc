#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/map_parts.hpp"
#include "cli/options.hpp"
#include "cli/perceive_parts.hpp"
#include "cli/place_pictures.hpp"
#include "io/detector_lines.hpp"
#include "io/trace_file.hpp"
#include "perception/checked_detector.hpp"
#include "perception/command_detector.hpp"
#include "perception/shared_detector.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

class Run {
 public:
  explicit Run(const PerceiveCommand& command) : command_(command) {
    if (command.plugin) {
      detector_ = load_detector(*command.plugin);
    } else if (command.program) {
      detector_ = command_detector({*command.program}, scan_line, read_visit_line);
    } else {
      auto own = std::make_unique<ScanDetector>(command.detector);
      own_ = own.get();
      detector_ = std::move(own);
    }
    trace_.name = stem_of(command.log);
  }

  int operator()() {
    LogReader log(command_.log, command_.laser);
    if (command_.output != "-") make_map_folder();
    const std::size_t scans = detect(
        log, *detector_,
        [&](const Scan&) {
          if (own_ && command_.plots_folder) pictures_.follow(*own_);
        },
        [&](DetectedVisit visit) { add(std::move(visit)); });
    require_visits(trace_, command_.log, scans);
    if (command_.output == "-") {
      fmt::print("{}", trace_json(trace_));
    } else {
      write_trace_file(command_.output, trace_);
      tell(scans);
    }
    if (command_.plots_folder) pictures_.write(*command_.plots_folder, trace_.name);
    return exit_consistent;
  }

 private:
  void make_map_folder() {
    const fs::path output(command_.output);
    map_folder_ = output.parent_path() / (stem_of(command_.output) + ".lpm");
    make_folder(map_folder_);
  }

  void add(DetectedVisit detected) {
    if (own_ && command_.plots_folder) pictures_.add(detected, *own_);
    if (detected.place_map && command_.output != "-") {
      detected.visit.lpm = write_place_map(map_folder_, trace_.visits.size(), *detected.place_map);
    }
    trace_.visits.push_back(std::move(detected.visit));
  }

  void tell(std::size_t scans) const {
    fmt::print("{}: {} scans, {} visits, {} travels\n", trace_.name, scans, trace_.visits.size(),
               trace_.visits.size() - 1);
    for (std::size_t i = 0; i < trace_.visits.size(); ++i) {
      fmt::print("  {}", visit_row(i, trace_.visits[i]));
    }
  }

  const PerceiveCommand& command_;
  std::unique_ptr<PlaceDetector> detector_;
  ScanDetector* own_ = nullptr;  // the detector that ships, if it is that one
  PlacePictures pictures_;
  fs::path map_folder_;
  Trace trace_;
};

}  // namespace

int perceive_command(const PerceiveCommand& command) { return Run(command)(); }

}  // namespace asterism
