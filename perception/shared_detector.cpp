#include "perception/shared_detector.hpp"

#include <dlfcn.h>

#include <exception>
#include <string_view>

#include "perception/checked_detector.hpp"
#include "perception/plugin.hpp"
#include "perception/plugin_error.hpp"

namespace asterism {
namespace {

static_assert(std::string_view(DetectorPlugin::current_version) == ASTERISM_VERSION,
              "perception/plugin.hpp and CMakeLists.txt tell two versions");

constexpr const char* entry_point = "asterism_detector_plugin";

class SharedLibrary {
 public:
  explicit SharedLibrary(const std::string& file) {
    // Without a slash the system would look in its own folders.
    const std::string place = file.find('/') == std::string::npos ? "./" + file : file;
    handle_ = ::dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_) return;
    const char* reason = ::dlerror();
    std::string found = one_line(reason ? reason : "an unknown failure");
    if (found.starts_with(place + ": ")) found.erase(0, place.size() + 2);
    throw plugin_error(file, found, "a shared library");
  }
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;
  ~SharedLibrary() { ::dlclose(handle_); }

  /// Null where the library has no such symbol.
  const void* find(const char* symbol) const { return ::dlsym(handle_, symbol); }

 private:
  void* handle_;
};

/// The text of a plug-in, in quotes.
std::string quoted(const char* text) {
  return text ? '"' + one_line(text, 60) + '"' : std::string("nothing");
}

void require_same(const std::string& file, const char* what, const char* found,
                  const char* expected) {
  if (!found || std::string_view(found) != expected)
    throw plugin_error(file, std::string(what) + ' ' + quoted(found), quoted(expected));
}

/// The library's plug-in, once it is known to be what this program was built for.
const DetectorPlugin& plugin_of(const SharedLibrary& library, const std::string& file) {
  const auto* plugin = static_cast<const DetectorPlugin*>(library.find(entry_point));
  if (!plugin)
    throw plugin_error(file, "no symbol " + std::string(entry_point), "a detector's entry point");
  if (plugin->form != DetectorPlugin::current_form)
    throw plugin_error(file, "entry point of form " + std::to_string(plugin->form),
                       "form " + std::to_string(DetectorPlugin::current_form));
  require_same(file, "asterism version", plugin->version, DetectorPlugin::current_version);
  require_same(file, "compiler", plugin->compiler, DetectorPlugin::current_compiler);
  if (plugin->sizes != DetectorPlugin::current_sizes)
    throw plugin_error(file, "scans and visits of another layout",
                       "the headers and compiler options of this program");
  if (!plugin->create) throw plugin_error(file, "no create function", "one");
  return *plugin;
}

/// What `act` returns; an exception becomes a PluginError that begins with `where`. The exception
/// is gone before the library that may hold its code and text can be.
template <class Act>
auto guarded(const std::string& where, const Act& act) {
  try {
    return act();
  } catch (const std::exception& error) {
    throw plugin_error(where, one_line(error.what()));
  } catch (...) {
    throw plugin_error(where, "something thrown", "nothing but std::exception thrown");
  }
}

class SharedDetector : public PlaceDetector {
 public:
  explicit SharedDetector(const std::string& file)
      : file_(file),
        library_(file),
        detector_(guarded(file + ": create", plugin_of(library_, file).create)) {
    if (!detector_) throw plugin_error(file + ": create", "no detector", "one");
    name_ = detector_->name();
  }

  std::string_view name() const noexcept override { return name_; }

  std::optional<DetectedVisit> observe(const Scan& scan) override {
    return guarded(file_ + ": scan " + std::to_string(scan.number),
                   [&] { return detector_->observe(scan); });
  }

  std::optional<DetectedVisit> finish() override {
    return guarded(file_ + ": end of the log", [&] { return detector_->finish(); });
  }

 private:
  std::string file_;
  SharedLibrary library_;                    // outlives
  std::unique_ptr<PlaceDetector> detector_;  // whose code it holds
  std::string name_;
};

}  // namespace

std::unique_ptr<PlaceDetector> load_detector(const std::string& file) {
  return checked(std::make_unique<SharedDetector>(file), file);
}

}  // namespace asterism
