#include "io/json/json_writer.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/id.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

using Style = JsonWriter::Style;

template <class Value>
std::string written(const Value& value, Style style = Style::spaced) {
  JsonWriter json(style);
  json.value(value);
  return json.take();
}

}  // namespace

TEST_CASE("values are spelt as JSON has them", "[io]") {
  CHECK(written(true) == "true");
  CHECK(written(-3) == "-3");
  CHECK(written(UINT64_MAX) == "18446744073709551615");
  CHECK(written(PlaceId(4)) == "4");
  CHECK(written("a") == "\"a\"");
  CHECK(written(std::string("\"\n\\")) == R"("\"\n\\")");
  CHECK(written(std::optional<int>()) == "null");
  CHECK(written(std::optional<int>(2)) == "2");
  CHECK(written(std::vector<int>{}) == "[]");
  CHECK(written(std::vector<std::vector<int>>{{1, 2}, {}}) == "[[1, 2], []]");
}

TEST_CASE("a real number reads back as itself", "[io]") {
  CHECK(written(0.1) == "0.1");
  CHECK(written(2.0) == "2");
  CHECK(written(1e5) == "1e+05");
  CHECK(written(2.0, Style::compact) == "2.0");
  CHECK(written(1e5, Style::compact) == "100000.0");
  for (const double number : {1.0 / 3, -5e-324, 1.7976931348623157e308}) {
    CHECK(std::strtod(written(number).c_str(), nullptr) == number);
    CHECK(std::strtod(written(number, Style::compact).c_str(), nullptr) == number);
  }
}

TEST_CASE("what JSON cannot say is not written", "[io]") {
  const auto style = GENERATE(Style::spaced, Style::compact);
  CHECK_THROWS_AS(written(std::numeric_limits<double>::infinity(), style), std::invalid_argument);
  CHECK_THROWS_AS(written(std::numeric_limits<double>::quiet_NaN(), style), std::invalid_argument);
  CHECK_THROWS_AS(written("\xFF", style), std::invalid_argument);
}

TEST_CASE("objects and arrays are as wide as asked for", "[io]") {
  const auto write = [](JsonWriter& json) {
    json.object([&] {
      json.member("a", 1);
      json.member_if("b", std::optional<int>());
      json.member_if("c", std::optional("x"));
      json.key("d").tight().object([&] { json.member("e", std::array{2, 3}); });
      json.key("f").object([] {});
      json.key("g").null();
    });
  };
  CHECK(json_written(write) == R"({ "a": 1, "c": "x", "d": {"e": [2, 3]}, "f": {}, "g": null })");
  JsonWriter compact(Style::compact);
  write(compact);
  CHECK(compact.take() == R"({"a":1,"c":"x","d":{"e":[2,3]},"f":{},"g":null})");
}

TEST_CASE("a line begins where it is said, indented by its level", "[io]") {
  const std::vector<int> numbers{1, 2};
  const auto write = [&](JsonWriter& json) {
    json.object([&] {
      json.member("a", 0);
      json.line().member("b", 0);
      json.line().key("c").lines(numbers, [&](JsonWriter& to, int number) {
        to.object([&] {
          to.member("d", number);
          to.line().key("e").tight().lines(
              numbers, [](JsonWriter& inner, int other) { inner.value(other); });
        });
      });
      json.key("f").array([&] { json.line(); });
      json.line();
    });
  };
  CHECK(json_written(write) == R"({ "a": 0,
  "b": 0,
  "c": [
    { "d": 1,
      "e": [
        1,
        2] },
    { "d": 2,
      "e": [
        1,
        2] } ], "f": [
  ]
})");
  JsonWriter compact(Style::compact);
  write(compact);
  CHECK(compact.take() == R"({"a":0,
  "b": 0,
  "c": [
    {"d":1,
      "e": [
        1,
        2]},
    {"d":2,
      "e": [
        1,
        2]}],"f":[
  ]
})");
}

TEST_CASE("what was written can be taken away piece by piece", "[io]") {
  JsonWriter json;
  std::string text;
  json.array([&] {
    for (int i = 0; i < 3; ++i) {
      json.line().value(i);
      text += json.take();
    }
  });
  CHECK(text + json.take() == "[\n  0,\n  1,\n  2 ]");
}

TEST_CASE("a value that was read is written as it was", "[io]") {
  const std::string text = R"({"a": [1, -2, 0.10, {}], "b": {"c": null, "d": true}, "é": ""})";
  CHECK(json_of(parse_json(text, "x")) == text);
  CHECK(written(parse_json(text, "x"), Style::compact) ==
        R"({"a":[1,-2,0.1,{}],"b":{"c":null,"d":true},"é":""})");
}
