#include "perception/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <system_error>
#include <thread>
#include <utility>

namespace asterism {
namespace {

using Clock = std::chrono::steady_clock;

void require(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

struct Pipe {
  Descriptor reading;
  Descriptor writing;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  require(::pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno, "pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

void make_non_blocking(const Descriptor& descriptor) {
  const int flags = ::fcntl(descriptor.number(), F_GETFL);
  require(::fcntl(descriptor.number(), F_SETFL, flags | O_NONBLOCK) == 0 ? 0 : errno, "fcntl");
}

/// How a program is started: with these ends of pipes as standard input and output, as the head of
/// a process group of its own, by which all it starts can be killed, and with the usual signals.
class SpawnSettings {
 public:
  SpawnSettings(const Descriptor& input, const Descriptor& output) {
    require(::posix_spawn_file_actions_init(&files_), "posix_spawn");
    require(::posix_spawnattr_init(&attributes_), "posix_spawn");
    require(::posix_spawn_file_actions_adddup2(&files_, input.number(), STDIN_FILENO), "dup2");
    require(::posix_spawn_file_actions_adddup2(&files_, output.number(), STDOUT_FILENO), "dup2");
    ::sigset_t none, broken_pipe;
    ::sigemptyset(&none);
    ::sigemptyset(&broken_pipe);
    ::sigaddset(&broken_pipe, SIGPIPE);
    require(::posix_spawnattr_setsigmask(&attributes_, &none), "posix_spawn");
    require(::posix_spawnattr_setsigdefault(&attributes_, &broken_pipe), "posix_spawn");
    require(::posix_spawnattr_setpgroup(&attributes_, 0), "posix_spawn");
    require(::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF |
                                                         POSIX_SPAWN_SETSIGMASK),
            "posix_spawn");
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&files_);
  }

  ::pid_t spawn(std::string command) const {
    std::string shell = "/bin/sh", option = "-c";
    const std::array<char*, 4> arguments{shell.data(), option.data(), command.data(), nullptr};
    ::pid_t process = -1;
    require(
        ::posix_spawn(&process, shell.c_str(), &files_, &attributes_, arguments.data(), ::environ),
        "/bin/sh");
    return process;
  }

 private:
  ::posix_spawn_file_actions_t files_{};
  ::posix_spawnattr_t attributes_{};
};

/// While it stands, writing to a pipe that nobody reads is an error and no signal, in this thread.
class NoBrokenPipeSignal {
 public:
  NoBrokenPipeSignal() {
    ::sigset_t pending;
    ::sigpending(&pending);
    was_pending_ = ::sigismember(&pending, SIGPIPE) == 1;
    ::sigemptyset(&broken_pipe_);
    ::sigaddset(&broken_pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &broken_pipe_, &before_);
  }
  NoBrokenPipeSignal(const NoBrokenPipeSignal&) = delete;
  NoBrokenPipeSignal& operator=(const NoBrokenPipeSignal&) = delete;
  ~NoBrokenPipeSignal() {
    const int error = errno;
    const ::timespec at_once{};
    if (!was_pending_)
      while (::sigtimedwait(&broken_pipe_, nullptr, &at_once) < 0 && errno == EINTR) {
      }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = error;
  }

 private:
  ::sigset_t broken_pipe_{};
  ::sigset_t before_{};
  bool was_pending_ = false;
};

/// What is left until then in whole milliseconds, rounded up so that poll does not spin.
int milliseconds_until(Clock::time_point end) {
  const std::chrono::duration<double, std::milli> left = end - Clock::now();
  return static_cast<int>(std::ceil(std::clamp(left.count(), 0.0, 1e9)));
}

Clock::time_point after(ChildProcess::Duration time) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

void Descriptor::close() noexcept {
  if (number_ >= 0) ::close(std::exchange(number_, -1));
}

ChildProcess::ChildProcess(const std::string& command) {
  Pipe input = make_pipe();
  Pipe output = make_pipe();
  make_non_blocking(input.writing);  // of our own ends only: the program may block as it likes
  make_non_blocking(output.reading);
  process_ = SpawnSettings(input.reading, output.writing).spawn(command);
  input_ = std::move(input.writing);
  output_ = std::move(output.reading);
}

ChildProcess::~ChildProcess() {
  // Not yet waited for, so that the number is still this group's, even if its head has ended.
  ::kill(-process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

ChildProcess::Ready ChildProcess::wait(bool for_writing, Duration at_most) const {
  const auto end = after(at_most);
  // A negative descriptor is passed over.
  std::array<::pollfd, 2> files{::pollfd{output_.number(), POLLIN, 0},
                                ::pollfd{for_writing ? input_.number() : -1, POLLOUT, 0}};
  int ready = 0;
  while ((ready = ::poll(files.data(), files.size(), milliseconds_until(end))) < 0)
    require(errno == EINTR ? 0 : errno, "poll");
  return {files[0].revents != 0, files[1].revents != 0};
}

std::optional<std::size_t> ChildProcess::write(std::string_view text) {
  const NoBrokenPipeSignal guard;
  const ::ssize_t written = ::write(input_.number(), text.data(), text.size());
  if (written >= 0) return static_cast<std::size_t>(written);
  if (errno == EPIPE) return std::nullopt;
  require(errno == EAGAIN || errno == EINTR ? 0 : errno, "write");
  return 0;
}

std::optional<std::string> ChildProcess::read() {
  std::array<char, 65536> buffer;
  const ::ssize_t size = ::read(output_.number(), buffer.data(), buffer.size());
  if (size > 0) return std::string(buffer.data(), static_cast<std::size_t>(size));
  if (size == 0) return std::nullopt;
  require(errno == EAGAIN || errno == EINTR ? 0 : errno, "read");
  return "";
}

std::optional<std::string> ChildProcess::ending(Duration at_most) const {
  const auto end = after(at_most);
  // There is no portable way to wait for a process and the clock at once; ends are seldom waited
  // for, since a program's output ends with it.
  for (;;) {
    ::siginfo_t info{};
    const int failed =
        ::waitid(P_PID, static_cast<::id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT);
    require(failed == 0 || errno == EINTR ? 0 : errno, "waitid");
    if (failed == 0 && info.si_pid == process_)
      return (info.si_code == CLD_EXITED ? "exit status " : "signal ") +
             std::to_string(info.si_status);
    if (Clock::now() >= end) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace asterism
