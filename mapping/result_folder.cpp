#include "mapping/result_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/shown.hpp"
#include "mapping/log_files.hpp"
#include "mapping/model_files.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
  std::error_code error;
  return {fs::directory_iterator(folder, error), fs::directory_iterator()};
}

/// Whether a name is this, a number and that.
bool is_numbered(std::string_view name, std::string_view before, std::string_view after) {
  if (name.size() <= before.size() + after.size() || !name.starts_with(before) ||
      !name.ends_with(after))
    return false;
  name = name.substr(before.size(), name.size() - before.size() - after.size());
  return std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

bool is_result(const fs::path& file) {
  const std::string folder = file.parent_path().string();
  const std::string name = file.filename().string();
  const auto is_one_of = [&](const auto& names) {
    return std::ranges::find(names, name) != std::ranges::end(names);
  };
  if (folder == "log.lpm")
    return name == "perception.json" || is_numbered(name, "visit-", ".json") ||
           is_numbered(name, "visit-", ".png");
  if (is_numbered(folder, "model-", "")) return is_one_of(model_file_names);
  return folder.empty() && (is_one_of(model_file_names) || is_one_of(log_file_names));
}

/// The folders that a run makes, and what may lie beside its files.
bool is_result_folder(const fs::path& name) {
  return name == "log.lpm" || is_numbered(name.string(), "model-", "");
}

/// Files as deep as a run's lie: those it gives, or all others, from where the folder lies. Of
/// others' folders only their names: what is in them is no concern of a run.
std::vector<fs::path> files_in(const fs::path& folder, bool of_a_run) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& file) {
    const bool is_folder = fs::is_directory(fs::symlink_status(folder / file));
    if ((is_result(file) && !is_folder) == of_a_run) files.push_back(file);
  };
  for (const fs::directory_entry& entry : entries_of(folder)) {
    const fs::path name = entry.path().filename();
    if (!entry.is_directory() || entry.is_symlink() || !is_result_folder(name)) {
      add(name);
      continue;
    }
    for (const fs::directory_entry& inner : entries_of(entry.path()))
      add(name / inner.path().filename());
  }
  return files;
}

/// The folders that a run makes, where they are empty.
void remove_empty_folders(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : entries_of(folder))
    if (is_result_folder(entry.path().filename())) fs::remove(entry.path(), error);
}

/// From where, to where.
using Move = std::pair<fs::path, fs::path>;

std::vector<Move> moves(const std::vector<fs::path>& files, const fs::path& from,
                        const fs::path& to) {
  std::vector<Move> result;
  for (const fs::path& file : files) result.emplace_back(from / file, to / file);
  return result;
}

/// Moves all; where one cannot be moved, those before it are moved back.
std::optional<MoveFault> move_all(const std::vector<Move>& moves) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    std::error_code error;
    const auto& [from, to] = moves[i];
    fs::create_directories(to.parent_path(), error);
    if (!error) fs::rename(from, to, error);
    if (!error) continue;
    bool are_back = true;
    while (i-- > 0) {
      std::error_code again;
      fs::rename(moves[i].second, moves[i].first, again);
      are_back = are_back && !again;
    }
    return MoveFault{error, are_back};
  }
  return std::nullopt;
}

/// Gives each a second name, but folders, and where the disk knows no second names.
std::error_code link_all(const std::vector<Move>& names) {
  for (const auto& [from, to] : names) {
    if (fs::is_directory(fs::symlink_status(from))) continue;
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    if (!error) fs::create_hard_link(from, to, error);
    const bool can_link = error != std::errc::operation_not_permitted &&
                          error != std::errc::operation_not_supported &&
                          error != std::errc::function_not_supported &&
                          error != std::errc::too_many_links;
    if (error && can_link) return error;
  }
  return {};
}

/// Takes second names away again.
void remove_links(const std::vector<Move>& names) {
  for (const auto& [from, to] : names) {
    std::error_code ignored;
    if (!fs::is_directory(fs::symlink_status(from, ignored))) fs::remove(to, ignored);
  }
}

/// Whether the program runs in a folder: the one that started it would find itself in one that is
/// no more.
bool holds_working_folder(const fs::path& folder) {
  std::error_code error;
  const fs::path inside = fs::relative(fs::current_path(error), folder, error);
  return error || inside.empty() || *inside.begin() != "..";
}

/// Whether a file is the half of a result, which was never given its name: see write_atomically.
bool is_half(const fs::path& file) {
  constexpr std::string_view ending = ".part";
  std::string name = file.filename().string();
  if (!name.ends_with(ending)) return false;
  name.resize(name.size() - ending.size());
  const std::size_t dot = name.rfind('.');
  return dot != std::string::npos && name.find('-', dot) != std::string::npos &&
         name.find_first_not_of("0123456789-", dot + 1) == std::string::npos &&
         is_result(file.parent_path() / name.substr(0, dot));
}

/// Whether two names are of one file.
bool are_one(const fs::path& one, const fs::path& other) {
  struct stat a, b;
  return ::lstat(one.c_str(), &a) == 0 && ::lstat(other.c_str(), &b) == 0 && a.st_dev == b.st_dev &&
         a.st_ino == b.st_ino;
}

/// Removes what a run that was killed left, but nothing that it could not move and has kept.
/// @throws Error if it has
void remove_left_over(const fs::path& unfinished, const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(unfinished, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status))
    throw Error(unfinished.string() + ": found no folder; expected one to write to, or none");
  for (const fs::path& file : files_in(unfinished, false)) {
    const bool is_file = fs::is_regular_file(fs::symlink_status(unfinished / file, error));
    if (!(is_file && is_half(file)) && !are_one(unfinished / file, folder / file))
      throw Error(
          fmt::format("{}: found {}, kept by an earlier run that could not move it; "
                      "expected it to be moved away first",
                      unfinished.string(), file.string()));
  }
  fs::remove_all(unfinished, error);
}

bool change_places(const fs::path& one, const fs::path& other) {
  return ::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace

ResultFolder::ResultFolder(const fs::path& folder) : is_new_(!exists(folder)) {
  make_folder(folder);
  folder_ = fs::canonical(folder);
  unfinished_ = folder_ / ".unfinished";
  fs::path beside = folder_;
  beside += ".unfinished";
  remove_left_over(unfinished_, folder_);
  remove_left_over(beside, folder_);
  make_folder(unfinished_);
  if (holds_working_folder(folder_)) return;
  // Made inside and moved out: so it is known to be on the same disk.
  std::error_code error;
  fs::rename(unfinished_, beside, error);
  if (!error) unfinished_ = beside;
}

ResultFolder::~ResultFolder() {
  std::error_code error;
  if (!is_kept_) fs::remove_all(unfinished_, error);
  if (is_new_) fs::remove(folder_, error);  // if it is empty
}

void ResultFolder::finish() {
  is_kept_ = true;
  const bool is_beside = unfinished_.parent_path() != folder_;
  if (!is_beside || !swap()) move_one_by_one();
  is_kept_ = false;
  std::error_code ignored;
  fs::remove_all(unfinished_, ignored);
}

/// @return  whether the folders can change places
bool ResultFolder::swap() {
  std::error_code ignored;
  fs::permissions(unfinished_, fs::status(folder_, ignored).permissions(), ignored);
  // What is not ours gets a second name in the new folder before they do.
  const std::vector<Move> names = moves(files_in(folder_, false), folder_, unfinished_);
  if (const std::error_code error = link_all(names)) {
    remove_links(names);
    refuse({error}, true);
  }
  if (!change_places(unfinished_, folder_)) {
    remove_links(names);
    return false;
  }
  // To move a file to its second name does nothing. Where the names are of two, the newer wins.
  if (const auto fault = move_all(moves(files_in(unfinished_, false), unfinished_, folder_))) {
    const bool are_back = change_places(unfinished_, folder_) && fault->are_back;
    if (are_back) remove_links(names);
    refuse(*fault, are_back);
  }
  return true;
}

void ResultFolder::move_one_by_one() {
  const fs::path before = unfinished_ / ".before";
  std::vector<Move> all = moves(files_in(folder_, true), folder_, before);
  std::ranges::copy(moves(files_in(unfinished_, true), unfinished_, folder_),
                    std::back_inserter(all));
  if (const auto fault = move_all(all)) {
    remove_empty_folders(before);
    std::error_code ignored;
    fs::remove(before, ignored);
    remove_empty_folders(folder_);
    refuse(*fault, fault->are_back);
  }
  remove_empty_folders(folder_);
}

void ResultFolder::refuse(const MoveFault& fault, bool are_back) const {
  const std::string found = system_message(fault.error.value());
  if (are_back)
    throw Error(
        fmt::format("{}: found {}; expected to replace the results there, which are as they "
                    "were; the new ones lie in {}",
                    folder_.string(), found, unfinished_.string()));
  throw Error(fmt::format("{}: found {}; expected to move there what is in {} now",
                          folder_.string(), found, unfinished_.string()));
}

}  // namespace asterism
