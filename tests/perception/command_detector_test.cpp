#include "perception/command_detector.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>

#include "io/json/detector_lines.hpp"
#include "perception/plugin_error.hpp"
#include "tests/perception/corridor_drive.hpp"
#include "tests/perception/messages.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

/// Far more than fits into a pipe that nobody reads.
const std::vector<Scan>& drive() {
  static const auto scans = corridor_drive();
  return scans;
}

const std::string visit = R"({"star": "a+1 a-1", "entered_by": "a+", "left_by": "a-"})";

std::unique_ptr<PlaceDetector> detector(const std::string& command, double patience_s = 300) {
  return command_detector({command, patience_s}, scan_line, read_visit_line);
}

std::string complaint(const std::string& command, double patience_s = 300) {
  return complaint_of([&] { visits_of(*detector(command, patience_s), drive()); });
}

/// Text of that size, by a program.
std::string bytes(int size) {
  return "head -c " + std::to_string(size) + " /dev/zero | tr '\\0' x";
}

}  // namespace

TEST_CASE("a command is given every scan, and told when there are no more", "[perception]") {
  CHECK(
      visits_of(*detector("test $(wc -l) -eq " + std::to_string(drive().size())), drive()).empty());
  CHECK(visits_of(*detector("test $(wc -l) -eq 0"), {}).empty());
}

TEST_CASE("a command's visits are all handed over, in order, whenever it tells of them",
          "[perception]") {
  const std::string command = GENERATE_COPY(
      "echo '" + visit + "'; echo '" + visit + "'; echo '" + visit + "'; cat > /dev/null",
      "cat > /dev/null; echo '" + visit + "'; echo '" + visit + "'; echo '" + visit + "'",
      "read scan; echo '" + visit + "'; cat > /dev/null; echo '" + visit + "'; echo '" + visit +
          "'");
  const auto program = detector(command);
  const auto visits = visits_of(*program, drive());
  REQUIRE(visits.size() == 3);
  CHECK(visits[2].visit.star.text() == "a+1 a-1");
  CHECK_FALSE(program->finish());
}

TEST_CASE("a command that writes more than a pipe holds before it reads does not stand still",
          "[perception]") {
  const std::string padded = R"(printf '{"star": "a+1 a-1", "entered_by": "a+", "left_by": "a+", )"
                             R"("x_padding": "'; )" +
                             bytes(300'000) + R"(; echo '"}')";
  CHECK(visits_of(*detector(padded + "; " + padded + "; cat > /dev/null"), drive()).size() == 2);
}

TEST_CASE("a line that is no visit is refused by its number", "[perception]") {
  const auto [line, reason] = GENERATE(table<std::string, std::string>({
      {"hello", ":line 2:1: found invalid literal; expected valid JSON"},
      {"", ":line 2:1: found end of input; expected '[', '{', or a literal"},
      {"{}", ":line 2:/star: found nothing; expected a string"},
      {R"({"star": "a+1 a-1", "left_by": "b+"})",
       ":line 2:/left_by: found \"b+\"; expected an arm of the star, like a+"},
  }));
  const std::string command = "echo '" + visit + "'; echo '" + line + "'; cat > /dev/null";
  const std::string message = complaint(command);
  CHECK(message.ends_with(reason));
  CHECK(message.starts_with(command.substr(0, 20)));
  CHECK(message.find('\n') == std::string::npos);
}

TEST_CASE("a command that does not end as it should is refused with the reason", "[perception]") {
  const auto [command, found] = GENERATE(table<std::string, std::string>({
      {"exit 3", "exit status 3; expected exit status 0"},
      {"head -n 1 > /dev/null; exit 4", "exit status 4; expected exit status 0"},
      {"cat > /dev/null; exit 5", "exit status 5; expected exit status 0"},
      {"kill -9 $$", "signal 9; expected exit status 0"},
      {"no-such-program 2> /dev/null", "exit status 127; expected exit status 0"},
      {"true",
       "its input or output closed before the end of the scans; expected it to read them all"},
      {"exec 0<&-; true",
       "its input or output closed before the end of the scans; expected it to read them all"},
  }));
  CHECK(complaint(command) == command + ": found " + found);
}

TEST_CASE("what a command said before it ended too early comes first", "[perception]") {
  CHECK(complaint("echo '{'; exit 3") ==
        "echo '{'; exit 3:line 1:2: found end of input; expected string literal");
}

TEST_CASE("a line without its end is refused", "[perception]") {
  CHECK(complaint("cat > /dev/null; printf '{}'") ==
        "cat > /dev/null; printf '{}':line 1: found a line without its end; expected a whole line");
}

TEST_CASE("a line without end is refused", "[perception]") {
  CHECK(complaint("tr '\\0' x < /dev/zero") ==
        "tr '\\0' x < /dev/zero:line 1: found more than 1048576 bytes; expected a shorter line");
}

TEST_CASE("visits without end are refused", "[perception]") {
  const std::string command = "yes '" + visit + "'";
  CHECK(complaint(command) ==
        one_line(command, 60) +
            ": found 100000 visits ahead of the scans; expected one a scan at most");
}

TEST_CASE("a command that neither reads, writes nor ends is given up", "[perception]") {
  const std::string command =
      GENERATE("exec sleep 1000", "cat > /dev/null; exec sleep 1000", "exec 0<&-; exec sleep 1000");
  CHECK(complaint(command, 0.25) ==
        command +
            ": found nothing read, written or ended for 0.25 s; expected a program that goes "
            "on");
}

TEST_CASE("a command that closes its output before its input ends is refused", "[perception]") {
  const std::string command = "exec 1>&-; cat > /dev/null; exec sleep 1000";
  CHECK(complaint(command, 2) ==  // time enough to close it, on a busy machine too

        command +
            ": found its input or output closed before the end of the scans; expected it to "
            "read them all");
}

TEST_CASE("a command that breaks a law is stopped", "[perception]") {
  const std::string line = "echo '{\"star\": \"a+1 a-1\"}'; ";
  CHECK(complaint("cat > /dev/null; " + line + line)
            .ends_with("...: visit 1/entered_by: found nothing; expected an arm"));
}

TEST_CASE("a command's name in messages is one line and not long", "[perception]") {
  const std::string message = complaint("exit 3\n#" + std::string(100, '-'));
  CHECK(message == "exit 3?#" + std::string(52, '-') +
                       "...: found exit status 3; expected exit "
                       "status 0");
}

TEST_CASE("a command let go of is killed with all it started", "[perception]") {
  const auto fifo =
      std::filesystem::temp_directory_path() / ("asterism-fifo-" + std::to_string(::getpid()));
  std::filesystem::remove(fifo);
  REQUIRE(::mkfifo(fifo.c_str(), 0600) == 0);

  auto program = detector("(echo here; exec sleep 1000) > '" + fifo.string() + "' & sleep 1000");
  const int file = ::open(fifo.c_str(), O_RDONLY);
  std::filesystem::remove(fifo);
  REQUIRE(file >= 0);
  std::array<char, 5> here{};
  REQUIRE(::read(file, here.data(), here.size()) == 5);
  program.reset();
  // The end of the file, which comes when nobody is left to write.
  CHECK(::read(file, here.data(), here.size()) == 0);
  ::close(file);
}

}  // namespace asterism
