#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace asterism {

/// An open file of this process, closed with this; -1 is none. For one thread at a time.
class Descriptor {
 public:
  /// Owns an open file from now on.
  explicit Descriptor(int number = -1) : number_(number) {}
  /// Leaves none behind.
  Descriptor(Descriptor&& other) noexcept;
  /// Swaps the two, so that the other closes what was held here.
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { close(); }

  /// What the system calls it.
  int number() const noexcept { return number_; }
  /// Closes it, if any; there is none afterwards.
  void close() noexcept;

 private:
  int number_;
};

/// A command of the shell whose input and output are ours; it keeps our error stream. Let go of, it
/// and all it started are killed. For one thread at a time.
class ChildProcess {
 public:
  /// Seconds.
  using Duration = std::chrono::duration<double>;

  /// @throws std::system_error if it cannot be started
  explicit ChildProcess(const std::string& command);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  /// What one can do now without waiting.
  struct Ready {
    bool to_read = false;
    bool to_write = false;
  };
  /// Waits until there is something to read (be it the end) or, if asked for, room to write; both
  /// false when the time is over.
  Ready wait(bool for_writing, Duration at_most) const;

  /// How many bytes of the text it takes now; nothing if it will never read again.
  std::optional<std::size_t> write(std::string_view text);
  /// Its input ends here.
  void close_input() noexcept { input_.close(); }

  /// What it has written since the last call; nothing if it will never write again.
  /// @pre wait has said that there is something to read
  std::optional<std::string> read();

  /// How it ended: "exit status 3", "signal 9"; nothing if it has not within the time.
  std::optional<std::string> ending(Duration at_most) const;

 private:
  Descriptor input_;   ///< we write to it
  Descriptor output_;  ///< we read from it
  int process_ = -1;   ///< its number
};

}  // namespace asterism
