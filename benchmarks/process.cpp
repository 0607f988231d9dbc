#include "benchmarks/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "benchmarks/measure.hpp"

extern char** environ;

namespace asterism {
namespace {

void require_zero(int error, const std::string& what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

pid_t spawn(const std::vector<std::string>& command, int output) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  require_zero(error, command.front());
  return child;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, double time_limit_s) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) require_zero(errno, "pipe");
  const auto [read_end, write_end] = ends;

  ProcessResult result;
  const Stopwatch stopwatch;
  const pid_t child = spawn(command, write_end);
  close(write_end);
  while (true) {
    const double left_s = time_limit_s - stopwatch.seconds();
    pollfd readable{read_end, POLLIN, 0};
    if (left_s <= 0 || poll(&readable, 1, static_cast<int>(left_s * 1000) + 1) == 0) {
      kill(child, SIGKILL);
      break;
    }
    std::array<char, 4096> buffer{};
    const ssize_t bytes = read(read_end, buffer.data(), buffer.size());
    if (bytes <= 0) break;
    result.output.append(buffer.data(), static_cast<std::size_t>(bytes));
  }
  close(read_end);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  result.wall_s = stopwatch.seconds();
  for (const timeval& time : {usage.ru_utime, usage.ru_stime})
    result.cpu_s += static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

ScratchFolder::ScratchFolder()
    : folder_(std::filesystem::temp_directory_path() /
              ("asterism-benchmark-" + std::to_string(getpid()))) {
  std::filesystem::create_directories(folder_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

}  // namespace asterism
