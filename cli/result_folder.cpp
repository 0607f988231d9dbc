#include "cli/result_folder.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>
#include <vector>

#include "cli/map_parts.hpp"
#include "cli/run_files.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_directory()) files.push_back(fs::relative(entry.path(), folder));
  return files;
}

/// Only files of names that a run gives: whatever else lies there is somebody's.
void remove_results(const fs::path& folder) {
  std::error_code error;  // what is not there, or not empty, stays
  for (const char* name : {"log.trace.json", "maps.json", "report.html"})
    fs::remove(folder / name, error);
  for (const char* pattern : {"visit-{}.json", "visit-{}.png"})
    remove_from(folder / "log.lpm", pattern, 0);
  fs::remove(folder / "log.lpm", error);
  remove_model(folder);
  for (std::size_t rank = 2;; ++rank) {
    const fs::path model = folder / fmt::format("model-{}", rank);
    if (!fs::is_directory(model, error)) break;
    remove_model(model);
    fs::remove(model, error);
  }
}

}  // namespace

ResultFolder::ResultFolder(fs::path folder)
    : folder_(std::move(folder)), unfinished_(folder_ / ".unfinished"), is_new_(!exists(folder_)) {
  make_folder(folder_);
  std::error_code error;
  fs::remove_all(unfinished_, error);  // of a run that was killed
  make_folder(unfinished_);
}

ResultFolder::~ResultFolder() {
  std::error_code error;
  fs::remove_all(unfinished_, error);
  if (is_new_) fs::remove(folder_, error);  // if it is empty
}

void ResultFolder::finish() {
  remove_results(folder_);
  for (const fs::path& file : files_in(unfinished_)) {
    fs::create_directories((folder_ / file).parent_path());
    fs::rename(unfinished_ / file, folder_ / file);
  }
}

}  // namespace asterism
