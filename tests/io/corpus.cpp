#include "tests/io/corpus.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

namespace asterism {
namespace {

namespace fs = std::filesystem;

const fs::path tests = fs::path(ASTERISM_SOURCE_DIR) / "tests";

/// Whether files of a kind are JSON, and lie in tests/traces too. Of other kinds any file is one.
bool is_json(const std::string& kind) {
  return kind == "trace" || kind == "maps" || kind == "expect" || kind == "detector_lines" ||
         kind == "checkpoint" || kind == "perception";
}

std::set<fs::path> listed(const fs::path& folder, const std::string& kind) {
  std::set<fs::path> result;
  for (const auto& entry : fs::directory_iterator(folder))
    if (!is_json(kind) || entry.path().filename().string().ends_with('.' + kind + ".json"))
      result.insert(entry.path());
  return result;
}

}  // namespace

std::vector<BadFile> bad_files(const std::string& kind) {
  const fs::path folder = tests / "corpus" / kind;
  std::vector<BadFile> result;
  std::set<fs::path> named;
  std::ifstream listing(folder / "bad.tsv");
  std::string line;
  std::getline(listing, line);  // the names of the columns
  while (std::getline(listing, line)) {
    const std::string file = line.substr(0, line.find('\t'));
    result.push_back({folder / "bad" / file, line.substr(line.rfind('\t') + 1)});
    named.insert(folder / "bad" / file);
  }
  if (named != listed(folder / "bad", kind))
    throw std::runtime_error("bad.tsv of " + kind + " does not name the files that are there");
  return result;
}

std::vector<fs::path> good_files(const std::string& kind) {
  auto files = listed(tests / "corpus" / kind / "good", kind);
  if (is_json(kind)) files.merge(listed(tests / "traces", kind));
  return {files.begin(), files.end()};
}

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace asterism
