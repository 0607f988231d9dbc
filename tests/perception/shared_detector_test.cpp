#include "perception/shared_detector.hpp"

#include <filesystem>
#include <fstream>

#include "tests/perception/corridor_drive.hpp"
#include "tests/perception/messages.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

std::string library(const std::string& name) {
  return std::string(ASTERISM_PLUGINS_DIR "/test_plugin_") + name + ".so";
}

std::string refusal(const std::string& file) {
  return complaint_of([&] { load_detector(file); });
}

}  // namespace

TEST_CASE("a library that is no detector for this program is refused with the reason",
          "[perception]") {
  const auto [name, reason] = GENERATE(table<std::string, std::string>({
      {"no_entry", ": found no symbol asterism_detector_plugin; expected a detector's entry point"},
      {"another_form", ": found entry point of form 2; expected form 1"},
      {"another_version", ": found asterism version \"0.0.9?\"; expected \"" ASTERISM_VERSION "\""},
      {"another_compiler", ": found compiler nothing; expected \"" __VERSION__ "\""},
      {"another_layout",
       ": found scans and visits of another layout; expected the headers and compiler options of "
       "this program"},
      {"no_create", ": found no create function; expected one"},
      {"null_detector", ": create: found no detector; expected one"},
      {"throwing_create", ": create: found no camera; expected one"},
  }));
  CHECK(refusal(library(name)) == library(name) + reason);
}

TEST_CASE("a file that is no library is refused with the reason", "[perception]") {
  const std::string missing = library("missing");
  CHECK(refusal(missing) == missing +
                                ": found cannot open shared object file: No such file or "
                                "directory; expected a shared library");
  CHECK(refusal(ASTERISM_PLUGINS_DIR).find("; expected a shared library") != std::string::npos);

  const auto text = std::filesystem::temp_directory_path() /
                    ("asterism-no-library-" + std::to_string(::getpid()) + ".so");
  std::ofstream(text) << "no library\n";
  CHECK(refusal(text.string()).find("; expected a shared library") != std::string::npos);
  std::filesystem::remove(text);

  // Not looked for in the system's folders, where there is one of this name.
  CHECK(refusal("libc.so.6").starts_with("libc.so.6: found "));
  CHECK(refusal("").starts_with(": found "));
}

TEST_CASE("what a library's detector throws becomes a plug-in error", "[perception]") {
  const auto detector = load_detector(library("throwing"));
  CHECK(detector->name() == "throwing");
  CHECK_FALSE(detector->observe({.number = 2}));
  CHECK(complaint_of([&] { detector->observe({.number = 3}); }) ==
        library("throwing") + ": scan 3: found smoke;?expected none");
  CHECK(complaint_of([&] { detector->finish(); }) ==
        library("throwing") +
            ": end of the log: found something thrown; expected nothing but std::exception thrown");
}

TEST_CASE("a library's detector that breaks a law is stopped", "[perception]") {
  const auto detector = load_detector(library("lawless"));
  CHECK(detector->observe({.number = 0}));
  CHECK(complaint_of([&] { detector->observe({.number = 1}); }) ==
        library("lawless") +
            ": visit 1/scans: found first 0; expected a scan after 0, where the visit before "
            "ended");
}

TEST_CASE("what a library handed over outlives it", "[perception]") {
  std::optional<DetectedVisit> visit;
  {
    const auto detector = load_detector(library("lawless"));
    visit = detector->observe({.number = 0});
  }
  REQUIRE(visit);
  CHECK(visit->visit.star.text() == "a+1 a-1");
}

}  // namespace asterism
