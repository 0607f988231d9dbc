#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asterism {

/// A file that must be refused, with this message after its name.
struct BadFile {
  std::filesystem::path file;
  std::string message;
};

/// The bad files of one kind, which is a folder of tests/corpus, as listed in bad.tsv (the file
/// first, the message last); which must list them all.
std::vector<BadFile> bad_files(const std::string& kind);

/// The good files of one kind. To traces belong those of tests/traces.
std::vector<std::filesystem::path> good_files(const std::string& kind);

std::string content(const std::filesystem::path& file);

}  // namespace asterism
