// Preloaded, lets calls on files below a folder fail: FAULT_FOLDER, and from the FAULT_FIRST-th
// such call on, FAULT_COUNT of them. How many there were is written to FAULT_TOLD.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

long calls = 0;
bool watched[4096];  ///< by descriptor: whether it is of a file below the folder

bool is_below(const char* path) {
  const char* folder = getenv("FAULT_FOLDER");
  return folder && path && strncmp(path, folder, strlen(folder)) == 0;
}

bool fails() {
  const char* first = getenv("FAULT_FIRST");
  const char* count = getenv("FAULT_COUNT");
  const long number = ++calls;
  if (!first || !count || number < atol(first) || number >= atol(first) + atol(count)) return false;
  errno = ENOSPC;
  return true;
}

__attribute__((destructor)) void tell() {
  const char* told = getenv("FAULT_TOLD");
  std::FILE* out = told ? std::fopen(told, "w") : nullptr;
  if (!out) return;
  fprintf(out, "%ld\n", calls);
  fclose(out);
}

#define NEXT(name) reinterpret_cast<decltype(&name)>(dlsym(RTLD_NEXT, #name))

int opened(int descriptor, const char* path, int flags) {
  const bool is_written = is_below(path) && (flags & (O_CREAT | O_WRONLY | O_RDWR)) != 0;
  if (descriptor >= 0 && descriptor < static_cast<int>(sizeof watched))
    watched[descriptor] = is_written;
  return descriptor;
}

bool is_watched(int descriptor) {
  return descriptor >= 0 && descriptor < static_cast<int>(sizeof watched) && watched[descriptor];
}

int open_by(int (*next)(const char*, int, ...), const char* path, int flags, va_list rest) {
  const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;
  if (is_below(path) && (flags & O_CREAT) && fails()) return -1;
  return opened(next(path, flags, mode), path, flags);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int descriptor = open_by(NEXT(open), path, flags, rest);
  va_end(rest);
  return descriptor;
}
int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int descriptor = open_by(NEXT(open64), path, flags, rest);
  va_end(rest);
  return descriptor;
}
FILE* fopen64(const char* path, const char* mode) {
  const bool writes = is_below(path) && mode[0] != 'r';
  if (writes && fails()) return nullptr;
  FILE* file = NEXT(fopen64)(path, mode);
  if (file) opened(fileno(file), path, writes ? O_WRONLY : 0);
  return file;
}
int close(int descriptor) {
  if (descriptor >= 0 && descriptor < static_cast<int>(sizeof watched)) watched[descriptor] = false;
  return NEXT(close)(descriptor);
}
ssize_t write(int descriptor, const void* bytes, size_t size) {
  return is_watched(descriptor) && fails() ? -1 : NEXT(write)(descriptor, bytes, size);
}
ssize_t writev(int descriptor, const struct iovec* parts, int count) {
  return is_watched(descriptor) && fails() ? -1 : NEXT(writev)(descriptor, parts, count);
}
int fsync(int descriptor) {
  return is_watched(descriptor) && fails() ? -1 : NEXT(fsync)(descriptor);
}
int rename(const char* from, const char* to) noexcept {
  return is_below(to) && fails() ? -1 : NEXT(rename)(from, to);
}
int link(const char* from, const char* to) noexcept {
  return is_below(to) && fails() ? -1 : NEXT(link)(from, to);
}
int renameat2(int from_at, const char* from, int to_at, const char* to, unsigned flags) noexcept {
  return is_below(to) && fails() ? -1 : NEXT(renameat2)(from_at, from, to_at, to, flags);
}
int mkdir(const char* path, mode_t mode) noexcept {
  return is_below(path) && fails() ? -1 : NEXT(mkdir)(path, mode);
}

}  // extern "C"
