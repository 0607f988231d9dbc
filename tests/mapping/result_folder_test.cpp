#include "mapping/result_folder.hpp"

#include <fstream>
#include <vector>

#include "core/error.hpp"
#include "tests/io/folder.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text = "") {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

std::string read(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("results that are finished replace those of an earlier run, and nothing else",
          "[mapping][unit]") {
  const Folder temporary;
  const fs::path folder = temporary.file("results");
  write(folder / "maps.json", "old");
  write(folder / "model-2" / "map.pgm");
  write(folder / "notes.txt", "mine");
  ResultFolder results(folder);
  write(results.unfinished() / "maps.json", "new");
  CHECK(read(folder / "maps.json") == "old");
  results.finish();
  CHECK(read(folder / "maps.json") == "new");
  CHECK(read(folder / "notes.txt") == "mine");
  CHECK_FALSE(fs::exists(folder / "model-2"));
}

TEST_CASE("what else lies in the folder of results stays where it is", "[mapping][unit]") {
  const bool works_there = GENERATE(false, true);  // so that the folder itself cannot be replaced
  const Folder temporary;
  const fs::path folder = temporary.file("results");
  const std::vector<fs::path> others{
      "notes.txt",         "log.lpm/visit-x.json", "log.lpm/mine/visit-0.json",
      "model-2/notes.txt", "model-x/map.pgm",      "photos/a/b.jpg"};
  const std::vector<fs::path> results{"map.png", "log.lpm/visit-0.json", "log.lpm/visit-2.png",
                                      "model-2/map.yaml", "model-31/layout.g2o"};
  for (const fs::path& file : others) write(folder / file, "mine");
  for (const fs::path& file : results) write(folder / file, "old");
  const fs::path before = fs::current_path();
  if (works_there) fs::current_path(folder);
  {
    ResultFolder now(works_there ? fs::path(".") : folder);
    write(now.unfinished() / "maps.json", "new");
    write(now.unfinished() / "model-2" / "map.pgm", "new");
    write(now.unfinished() / "log.lpm" / "visit-2.png", "new");
    now.finish();
  }
  fs::current_path(before);
  for (const fs::path& file : others) CHECK(read(folder / file) == "mine");
  CHECK(read(folder / "maps.json") == "new");
  CHECK(read(folder / "model-2" / "map.pgm") == "new");
  CHECK(read(folder / "log.lpm" / "visit-2.png") == "new");
  for (const char* gone : {"map.png", "log.lpm/visit-0.json", "model-2/map.yaml", "model-31",
                           ".unfinished", "../results.unfinished"})
    CHECK_FALSE(fs::exists(folder / gone));
}

TEST_CASE("results that cannot be moved one by one leave those of before, and are kept",
          "[mapping][unit]") {
  const Folder temporary;
  const fs::path folder = temporary.file("results");
  write(folder / "log.trace.json", "old");
  write(folder / "report.html" / "mine");  // a folder where a result has to be
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  {
    ResultFolder results(".");
    write(results.unfinished() / "log.trace.json", "new");
    write(results.unfinished() / "report.html", "new");
    CHECK_THROWS_AS(results.finish(), Error);
  }
  fs::current_path(before);
  CHECK(read(folder / "log.trace.json") == "old");
  CHECK(fs::exists(folder / "report.html" / "mine"));
  CHECK(read(folder / ".unfinished" / "log.trace.json") == "new");
}

TEST_CASE("a folder where a result has to be is left, with all beside it", "[mapping][unit]") {
  const Folder temporary;
  const fs::path folder = temporary.file("results");
  write(folder / "log.trace.json", "old");
  write(folder / "notes.txt", "mine");
  write(folder / "report.html" / "mine", "mine");
  fs::create_symlink("nowhere", folder / "link");
  for (int again = 0; again < 2; ++again) {
    ResultFolder results(folder);
    write(results.unfinished() / "log.trace.json", "new");
    write(results.unfinished() / "report.html", "new");
    CHECK_THROWS_AS(results.finish(), Error);
  }
  CHECK(read(folder / "log.trace.json") == "old");
  CHECK(read(folder / "notes.txt") == "mine");
  CHECK(read(folder / "report.html" / "mine") == "mine");
  CHECK(fs::is_symlink(folder / "link"));
  const fs::path unfinished = fs::path(folder) += ".unfinished";
  CHECK(read(unfinished / "report.html") == "new");
  CHECK_FALSE(fs::exists(unfinished / "notes.txt"));
}

TEST_CASE("what an earlier run has kept is not removed, what it left when it was killed is",
          "[mapping][unit]") {
  const Folder temporary;
  const fs::path folder = temporary.file("results");
  for (const fs::path& unfinished : {folder / ".unfinished", fs::path(folder) += ".unfinished"}) {
    write(unfinished / "maps.json", "half");
    write(unfinished / "report.html.123-0.part", "half");
    { const ResultFolder results(folder); }
    CHECK_FALSE(fs::exists(unfinished));
    // A second name of what is in the folder is no loss.
    write(folder / "notes.txt", "mine");
    fs::create_directory(unfinished);
    fs::create_hard_link(folder / "notes.txt", unfinished / "notes.txt");
    { const ResultFolder results(folder); }
    CHECK_FALSE(fs::exists(unfinished));
    CHECK(read(folder / "notes.txt") == "mine");
    fs::remove(folder / "notes.txt");
    for (const char* kept : {".before/maps.json", "notes.txt", "model-2/notes.txt", "film.part",
                             "notes.txt.12-0.part", "photos.part/one.png"}) {
      write(unfinished / kept, "mine");
      CHECK_THROWS_AS(ResultFolder(folder), Error);
      CHECK(read(unfinished / kept) == "mine");
      fs::remove_all(unfinished);
    }
    write(unfinished, "no folder");
    CHECK_THROWS_AS(ResultFolder(folder), Error);
    CHECK(read(unfinished) == "no folder");
    fs::remove(unfinished);
  }
}

TEST_CASE("results go where a link leads", "[mapping][unit]") {
  const Folder temporary;
  const fs::path folder = temporary.file("results");
  const fs::path link = temporary.file("link");
  fs::create_directory(folder);
  fs::create_directory_symlink(folder, link);
  ResultFolder results(link);
  write(results.unfinished() / "maps.json", "new");
  results.finish();
  CHECK(fs::is_symlink(link));
  CHECK(read(folder / "maps.json") == "new");
}

TEST_CASE("results that are not finished leave the folder as it was", "[mapping][unit]") {
  const Folder temporary;
  const fs::path known = temporary.file("known");
  const fs::path unknown = temporary.file("unknown");
  write(known / "maps.json", "old");
  for (const fs::path& folder : {known, unknown}) {
    const ResultFolder results(folder);
    write(results.unfinished() / "maps.json", "new");
  }
  CHECK(read(known / "maps.json") == "old");
  CHECK_FALSE(fs::exists(known / ".unfinished"));
  CHECK_FALSE(fs::exists(temporary.file("known.unfinished")));
  CHECK_FALSE(fs::exists(unknown));
}
