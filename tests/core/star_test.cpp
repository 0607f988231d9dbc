#include "core/star.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/support/catch.hpp"

using asterism::Star;

//        v+
//        |
//   h- --+-- h+        v- is missing: the stem ends here, v-0
//
namespace {
const char* const t_junction = "v+1 h+1 v-0 h-1";
}

TEST_CASE("a star is written as it was read", "[core]") {
  const auto text = GENERATE(as<std::string>{}, "v+1 v-0", t_junction, "a+1 b+1 a-1 b-0",
                             "long_Label9+0 long_Label9-1", "a+1 a-1 b+1 b-1");
  CHECK(Star::parse(text).text() == text);
}

TEST_CASE("opposite arms are the two directions of one local-path", "[core]") {
  const Star star = Star::parse("a+1 b+1 b-0 a-0");
  CHECK(star.opposite(0) == 3);
  CHECK(star.opposite(3) == 0);
  CHECK(star.opposite(1) == 2);
}

TEST_CASE("what a star looks like depends on the arm it is read from, not on labels", "[core]") {
  const Star seen = Star::parse("v+1 h+1 v-0 h-1");
  const Star relabelled = Star::parse("x-0 y-1 x+1 y+1");  // labels, signs and first arm differ
  CHECK(seen.view(0) == relabelled.view(2));
  CHECK(seen.view(0) != seen.view(1));
}

TEST_CASE("a star is never matched mirrored", "[core]") {
  const Star seen = Star::parse("a+1 a-0 b+1 b-1");
  const Star mirrored = Star::parse("b-1 b+1 a-0 a+1");
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) CHECK(seen.view(i) != mirrored.view(j));
}

TEST_CASE("a crossing matches itself from four arms", "[core]") {
  const Star crossing = Star::parse("v+1 h+1 v-1 h-1");
  for (std::size_t i = 0; i < 4; ++i) CHECK(crossing.view(i) == crossing.view(0));
}

TEST_CASE("opposite arms need not stand half-way round", "[core]") {
  const Star bent = Star::parse("a+1 a-1 b+1 b-1");
  const Star straight = Star::parse("a+1 b+1 a-1 b-1");
  CHECK(bent.view(0) != straight.view(0));
  CHECK(bent.view(0) == bent.view(2));
  CHECK(bent.view(0) != bent.view(1));
}

TEST_CASE("a broken star is refused", "[core]") {
  const auto text = GENERATE(as<std::string>{}, "", " ", "a", "a+", "a+1", "a+1 a+1", "a+0 a-0",
                             "a+1  a-1", "a+1 a-1 ", " a+1 a-1", "a+2 a-1", "a*1 a-1", "+1 -1",
                             "ä+1 ä-1", "a+1 b-1", "a+1\ta-1");
  CHECK_THROWS_AS(Star::parse(text), std::invalid_argument);
}

TEST_CASE("a star of more arms than any place has is refused", "[core]") {
  std::string text = "a0+1 a0-1";
  for (std::size_t i = 1; 2 * i < Star::max_arms; ++i)
    text += " a" + std::to_string(i) + "+1 a" + std::to_string(i) + "-1";
  CHECK(Star::parse(text).size() == Star::max_arms);
  CHECK_THROWS_AS(Star::parse(text + " b+1 b-1"), std::invalid_argument);
}
