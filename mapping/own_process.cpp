#include "mapping/own_process.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <new>

#include "core/error.hpp"
#include "io/shown.hpp"

namespace asterism {
namespace {

constexpr char is_found = '+';  ///< what is written begins so, or so:
constexpr char is_fault = '!';

[[noreturn]] void fail() {
  throw Error("found " + system_message(errno) + "; expected to start a process");
}

/// In the new process: nothing of what the old one has open or planned is for it.
[[noreturn]] void work_and_tell(const std::function<std::string()>& work, int out) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // It may well die, as Z3 does where memory is short: then without a word.
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  std::set_terminate([] { ::_exit(1); });
  std::string told;
  try {
    told = is_found + work();
  } catch (const std::bad_alloc&) {
    ::_exit(1);
  } catch (const SolverMemoryError&) {
    ::_exit(1);
  } catch (const std::exception& error) {
    told = is_fault + std::string(error.what());
  }
  for (std::size_t done = 0; done < told.size();) {
    const ssize_t written = ::write(out, told.data() + done, told.size() - done);
    if (written < 0 && errno != EINTR) ::_exit(1);
    done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  ::_exit(0);
}

/// What comes until the other end closes.
/// @return  nothing if it is not closed in time
std::optional<std::string> read_all(int in, Deadline deadline) {
  std::string text;
  char part[4096];
  while (true) {
    pollfd ready{in, POLLIN, 0};
    const bool is_soon = seconds_until(deadline) < 1e6;
    const int wait_ms = is_soon ? static_cast<int>(milliseconds_until(deadline)) : -1;
    const int count = ::poll(&ready, 1, wait_ms);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    const ssize_t size = ::read(in, part, sizeof part);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return text;
    text.append(part, static_cast<std::size_t>(size));
  }
}

}  // namespace

std::optional<std::string> in_own_process(const std::function<std::string()>& work,
                                          Deadline deadline) {
  int ends[2];
  if (::pipe(ends) != 0) fail();
  const pid_t child = ::fork();
  if (child < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    fail();
  }
  if (child == 0) {
    ::close(ends[0]);
    work_and_tell(work, ends[1]);
  }
  ::close(ends[1]);
  const std::optional<std::string> told = read_all(ends[0], deadline);
  ::close(ends[0]);
  ::kill(child, SIGKILL);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
  if (!told || told->empty()) return std::nullopt;
  if (told->front() == is_fault) throw Error(told->substr(1));
  return told->substr(1);
}

}  // namespace asterism
