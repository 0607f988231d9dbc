#include "io/picture/report_text.hpp"

#include <cmath>
#include <numbers>

#include "io/picture/svg.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("numbers have a true minus, and zero has none", "[io]") {
  CHECK(decimals(-1.504, 2) == "−1.50");
  CHECK(decimals(-0.004, 2) == "0.00");
  CHECK(decimals(12.34, 0) == "12");
}

TEST_CASE("counts are grouped in threes where they are long", "[io]") {
  CHECK(count_text(1234) == "1234");
  CHECK(count_text(12345) == "12\u202f345");
  CHECK(count_text(1234567) == "1\u202f234\u202f567");
  CHECK(counted(1, "map") == "1 map");
  CHECK(counted(0, "map") == "0 maps");
}

TEST_CASE("small probabilities are powers of ten", "[io]") {
  CHECK(probability_text(1) == "1.000");
  CHECK(probability_text(0.001) == "0.001");
  CHECK(probability_text(4.4e-5) == "4·10⁻⁵");
  CHECK(probability_text(9.7e-9) == "1·10⁻⁸");
  CHECK(probability_text(9.7e-12) == "under 10⁻⁹");
  CHECK(probability_text(0) == "under 10⁻⁹");
}

TEST_CASE("ratios have as many digits as count, and end at a million", "[io]") {
  CHECK(times_text(std::log(1.44)) == "1.4");
  CHECK(times_text(std::log(214)) == "210");
  CHECK(times_text(std::log(99'600)) == "100\u202f000");
  CHECK(times_text(std::log(2e6)) == "over a million");
  CHECK(times_text(5000) == "over a million");  // beyond what a double holds
}

TEST_CASE("poses and durations are for people", "[io]") {
  CHECK(pose_text({1, -2.5, std::numbers::pi / 2}) == "1.00, −2.50 m, 90.0°");
  CHECK(duration_text(59.4) == "59 s");
  CHECK(duration_text(1365.2) == "22 min 45 s");
  CHECK(duration_text(7262) == "2 h 1 min");
}

TEST_CASE("a file as a link is in base64", "[io]") {
  CHECK(data_uri("text/plain", "") == "data:text/plain;base64,");
  CHECK(data_uri("a/b", "f") == "data:a/b;base64,Zg==");
  CHECK(data_uri("a/b", "fo") == "data:a/b;base64,Zm8=");
  CHECK(data_uri("a/b", "foobar") == "data:a/b;base64,Zm9vYmFy");
  CHECK(data_uri("a/b", "\xff\xfe\xfb") == "data:a/b;base64,//77");
}
