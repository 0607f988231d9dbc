#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "core/error.hpp"
#include "io/shown.hpp"

namespace asterism {
namespace {

[[noreturn]] void fail(const std::string& file) {
  throw Error(file + ": found " + system_message(errno) + "; expected to write it");
}

/// A file of its own beside `file`, removed unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const std::string& file) : file_(file) {
    static std::atomic<unsigned> number = 0;
    name_ = file + '.' + std::to_string(::getpid()) + '-' + std::to_string(number++) + ".part";
    const int descriptor = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(file_);
    ::close(descriptor);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!renamed_) ::unlink(name_.c_str());
  }

  const std::string& name() const noexcept { return name_; }

  void rename() {
    bring_to_disk(name_, O_WRONLY);
    if (std::rename(name_.c_str(), file_.c_str()) != 0) fail(file_);
    renamed_ = true;
    const auto folder = std::filesystem::path(file_).parent_path();
    bring_to_disk(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
  }

 private:
  void bring_to_disk(const std::string& what, int flags) const {
    const int descriptor = ::open(what.c_str(), flags | O_CLOEXEC);
    if (descriptor < 0) fail(file_);
    const bool done = ::fsync(descriptor) == 0 || errno == EINVAL;  // not every file system can
    const int error = errno;
    ::close(descriptor);
    errno = error;
    if (!done) fail(file_);
  }

  std::string file_;
  std::string name_;
  bool renamed_ = false;
};

void write_to(const std::string& target, const std::string& file,
              const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(target, std::ios::binary | std::ios::trunc);
  if (!out) fail(file);
  write(out);
  out.close();
  if (!out) fail(file);
}

}  // namespace

void write_atomically(const std::string& file, const std::function<void(std::ostream&)>& write) {
  std::error_code ignored;  // what cannot be asked for cannot be written either
  const auto status = std::filesystem::symlink_status(file, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    write_to(file, file, write);
    return;
  }
  Temporary temporary(file);
  write_to(temporary.name(), file, write);
  temporary.rename();
}

void write_atomically(const std::string& file, std::string_view content) {
  write_atomically(file, [content](std::ostream& out) { out << content; });
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error(folder.string() + ": found " + system_message(error.value()) +
                "; expected a folder to write to");
}

void remove_from(const std::filesystem::path& folder, const std::string& pattern,
                 std::size_t number) {
  std::error_code error;
  while (std::filesystem::remove(folder / fmt::format(fmt::runtime(pattern), number), error))
    ++number;
}

}  // namespace asterism
