#include "io/atomic_file.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <ostream>

#include "core/error.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/folder.hpp"
#include "tests/support/catch.hpp"

namespace asterism {

namespace fs = std::filesystem;

TEST_CASE("a file is written whole, over what was there", "[io]") {
  const Folder folder;
  const std::string file = folder.file("maps.json");
  write_atomically(file, "first, and longer");
  write_atomically(file, [](std::ostream& out) { out << "second" << '\0' << '\n'; });
  CHECK(content(file) == std::string("second\0\n", 8));
  CHECK(folder.entries() == 1);
}

TEST_CASE("a write that fails leaves the file as it was", "[io]") {
  const Folder folder;
  const std::string file = folder.file("maps.json");
  write_atomically(file, "first");
  const auto fails = [](std::ostream& out) {
    out << "half";
    throw std::runtime_error("the rest is lost");
  };
  CHECK_THROWS_WITH(write_atomically(file, fails), "the rest is lost");
  CHECK_THROWS_AS(write_atomically(file, [](std::ostream& out) { out.setstate(std::ios::badbit); }),
                  Error);
  CHECK(content(file) == "first");
  CHECK(folder.entries() == 1);
}

TEST_CASE("what cannot be written is told", "[io]") {
  const Folder folder;
  CHECK_THROWS_WITH(
      write_atomically(folder.file("no/such"), "text"),
      folder.file("no/such") + ": found no such file or directory; expected to write it");
  fs::create_directory(folder.file("taken"));
  CHECK_THROWS_WITH(write_atomically(folder.file("taken"), "text"),
                    folder.file("taken") + ": found is a directory; expected to write it");
  CHECK(folder.entries() == 1);
}

TEST_CASE("what is no plain file is written in place", "[io]") {
  const Folder folder;
  write_atomically("/dev/null", "text");
  CHECK(fs::is_character_file("/dev/null"));
  CHECK_THROWS_AS(write_atomically("/dev/full", "text"), Error);

  write_atomically(folder.file("plain"), "first");
  fs::create_symlink("plain", folder.file("link"));
  write_atomically(folder.file("link"), "second");
  CHECK(fs::is_symlink(folder.file("link")));
  CHECK(content(folder.file("plain")) == "second");
}

}  // namespace asterism
