#include "io/picture/chart_svg.hpp"

#include "tests/io/picture/xml_check.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {
using Counts = std::vector<std::uint64_t>;

bool has(const std::string& svg, const std::string& part) {
  return svg.find(part) != std::string::npos;
}
}  // namespace

TEST_CASE("the chart names both series and its axes", "[io]") {
  const std::string svg = hypotheses_chart_svg("aces", {1, 1, 5, 83}, {1, 1, 4, 46});
  CHECK(is_well_formed(svg));
  for (const char* text : {"all: 83", "planar: 46", ">visit<", "maps that explain"})
    CHECK(has(svg, text));
  CHECK(count_of(svg, "<polyline") == 2);
}

TEST_CASE("the chart shows what there is", "[io]") {
  const auto [all, planar] =
      GENERATE(std::pair(Counts{1, 2}, Counts{}), std::pair(Counts{}, Counts{1, 2}),
               std::pair(Counts{}, Counts{}), std::pair(Counts{1}, Counts{0}));
  const std::string svg = hypotheses_chart_svg("part of it", all, planar);
  CHECK(is_well_formed(svg));
  CHECK(has(svg, "all: ") == !all.empty());
  CHECK(has(svg, "planar: ") == !planar.empty());
  CHECK_FALSE(has(svg, "nan"));
  CHECK_FALSE(has(svg, "inf"));
}

TEST_CASE("large ranges have an axis in powers of ten", "[io]") {
  const std::string svg = hypotheses_chart_svg("many", {1, 1000, 5'000'000}, {1, 10, 300});
  for (const char* tick : {">1<", ">100<", ">1000000<", ">10000000<"}) CHECK(has(svg, tick));
}
