#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/log_options.hpp"
#include "cli/option_checks.hpp"
#include "cli/progress.hpp"
#include "core/angle.hpp"
#include "io/atomic_file.hpp"
#include "io/json/detector_lines.hpp"
#include "io/json/trace_file.hpp"
#include "mapping/kept_perception.hpp"
#include "mapping/perceived.hpp"
#include "mapping/place_pictures.hpp"
#include "perception/checked_detector.hpp"
#include "perception/command_detector.hpp"
#include "perception/shared_detector.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

struct PerceiveCommand {
  std::string log;
  std::string output = "-";
  std::optional<std::string> plots_folder;
  std::optional<std::string> plugin;   ///< detector instead of the one that ships
  std::optional<std::string> program;  ///< the same
  LogOptions laser;
  ScanDetectorOptions detector;
};

/// One visit as a line of text.
std::string visit_row(std::size_t number, const Visit& visit) {
  const auto name = [&](const std::optional<std::size_t>& arm) {
    return arm ? visit.star.name(*arm) : std::string("-");
  };
  const std::string scans =
      visit.scans ? fmt::format("{} to {}", (*visit.scans)[0], (*visit.scans)[1]) : "-";
  return fmt::format("visit {:>3}  scans {:<16} in by {:<4} out by {:<4} star {}\n", number, scans,
                     name(visit.entered_by), name(visit.left_by), visit.star.text());
}

class Perceiving {
 public:
  explicit Perceiving(const PerceiveCommand& command) : command_(command) {
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
    const std::size_t scans = read(log);
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
  /// @return  how many scans
  std::size_t read(LogReader& log) {
    ReadProgress progress;
    std::size_t scans = 0;
    return detect(
        log, *detector_,
        [&](const Scan&) {
          if (own_ && command_.plots_folder) pictures_.follow(*own_);
          progress(log, ++scans, trace_.visits.size());
        },
        [&](DetectedVisit visit) { add(std::move(visit)); });
  }

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

int run(const PerceiveCommand& command) { return Perceiving(command)(); }

void add_options(CLI::App& perceive, PerceiveCommand& command) {
  add_log(perceive, command.log, command.laser);
  perceive.add_option("-o,--output", command.output, "Trace file; -: stdout")
      ->type_name("FILE")
      ->capture_default_str();
  CLI::Option& plots =
      *perceive
           .add_option("--plots", command.plots_folder,
                       "Draw each place as it was seen, a strip of all, and the robot's way")
           ->type_name("DIR");
  CLI::Option& library =
      *perceive
           .add_option("--detector", command.plugin,
                       "Shared library of a place detector; see docs/detectors.md")
           ->type_name("LIB");
  CLI::Option& program =
      *perceive
           .add_option("--detector-command", command.program,
                       "Program that reads scans and writes visits, as lines of JSON")
           ->type_name("CMD");
  library.excludes(&program);
  plots.excludes(&library)->excludes(&program);
  perceive
      .add_option_function<double>(
          "--heading",
          [&](double degrees) { command.detector.start_heading_rad = radians(degrees); },
          "Heading of the robot at the first scan, degrees from the map's x-axis [0]")
      ->type_name("DEG")
      ->check(number_between(-360, 360, "degrees, -360 to 360"))
      ->excludes(&library)
      ->excludes(&program);
  add_gateway_width(perceive, command.detector);
  perceive
      .add_option("--resolution", command.detector.lpm.resolution_m, "Side of a cell of the map")
      ->type_name("M")
      ->check(number_between(0.02, 0.5, "metres, 0.02 to 0.5"))
      ->capture_default_str();
  perceive.add_option("--cells", command.detector.lpm.cells, "Cells along each side of the map")
      ->type_name("N")
      ->check(CLI::Range(60, 2000))
      ->capture_default_str();
}

}  // namespace

void add_perceive(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "perceive", "Turn a laser log into a trace", add_options, run,
              R"(Examples:
  asterism perceive drive.log.xz -o drive.trace.json --plots drive-plots
  asterism perceive drive.log --max-range 8.18 --fov 180 -o drive.trace.json
  asterism perceive drive.log --detector-command 'python3 places.py' -o drive.trace.json
  asterism perceive drive.log | asterism map /dev/stdin --planar
With -o FILE.trace.json the maps of the places go to the folder FILE.lpm beside it.
Exit code: 0 there is a trace, 64 usage, 65 bad input or no place in it, 69 a detector that cannot
go on, 70 internal fault or a result that cannot be written.)");
}

}  // namespace asterism
