#include "io/json/perception_file.hpp"

#include <stdexcept>
#include <vector>

#include "core/random.hpp"
#include "io/json/digest.hpp"
#include "tests/io/corpus.hpp"
#include "tests/io/folder.hpp"
#include "tests/support/catch.hpp"

namespace asterism {

TEST_CASE("what was perceived reads back as it was written, to the last bit", "[io][property]") {
  RandomEngine random(1);
  const Folder folder;
  for (int round = 0; round < 50; ++round) {
    PerceptionRecord record{"by \"this\"", "0123456789abcdef", "fedcba9876543210"};
    for (std::size_t i = random() % 3; i > 0; --i)
      record.remarks.push_back("remark\n" + std::to_string(i));
    for (std::size_t i = random() % 30; i > 0; --i)
      record.map_from_robot.push_back(
          {between(-1e7, 1e7, random), between(-1e-7, 1e-7, random), between(-4, 4, random)});
    CHECK(read_perception(perception_json(record), "file") == record);
    write_perception_file(folder.file("perception.json"), record);
    CHECK(read_perception_file(folder.file("perception.json")) == record);
  }
  const PerceptionRecord far{"", "0000000000000000", "0000000000000000", {}, {{1e8, 0, 0}}};
  CHECK_THROWS_AS(perception_json(far), std::invalid_argument);
}

TEST_CASE("every good file of what was perceived is read", "[io][corpus]") {
  const auto files = good_files("perception");
  CHECK(files.size() == 2);
  for (const auto& file : files) {
    const PerceptionRecord record = read_perception_file(file.string());
    CHECK(read_perception(perception_json(record), "file") == record);
  }
}

TEST_CASE("a digest of scans tells all that they tell", "[io]") {
  const std::vector<Scan> scans{{.number = 3,
                                 .stamp_s = 1,
                                 .odom_from_robot = {1, 2, 3},
                                 .ranges_m = {1, 2},
                                 .laser = {0, 1, 8}},
                                {.number = 4, .stamp_s = 2, .ranges_m = {5}}};
  const std::string whole = digest(scans);
  CHECK(digest(scans) == whole);
  const auto changed = [&](auto change) {
    std::vector<Scan> other = scans;
    change(other);
    return digest(other) != whole;
  };
  CHECK(changed([](auto& s) { s[0].number = 2; }));
  CHECK(changed([](auto& s) { s[1].stamp_s = 2.5; }));
  CHECK(changed([](auto& s) { s[0].odom_from_robot.heading_rad = 0; }));
  CHECK(changed([](auto& s) { s[0].ranges_m[1] = 3; }));
  CHECK(changed([](auto& s) { s[0].laser.max_range_m = 9; }));
  CHECK(changed([](auto& s) { s[0].laser.robot_from_laser.x_m = 1; }));
  CHECK(changed([](auto& s) { s[0].odom_from_robot = {1, -2, -3}; }));
  CHECK(changed([](auto& s) { s.pop_back(); }));
  CHECK(changed([](auto& s) { std::swap(s[0], s[1]); }));
}

}  // namespace asterism
