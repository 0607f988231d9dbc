#include "engine/ask/query_reader.hpp"

#include "core/random.hpp"
#include "tests/io/corpus.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

namespace {

QueryError refusal(const std::string& text) {
  try {
    read_question(text);
  } catch (const QueryError& error) {
    return error;
  }
  FAIL("a query: " << text);
  throw std::logic_error("unreachable");
}

}  // namespace

TEST_CASE("texts that are no query are refused at the character", "[engine][query][corpus]") {
  for (const auto& [file, message] : bad_files("query")) {
    INFO(file);
    CHECK(refusal(content(file)).what() == "query, character " + message);
  }
}

TEST_CASE("texts that are queries are read", "[engine][query][corpus]") {
  const auto files = good_files("query");
  CHECK(files.size() > 10);
  for (const auto& file : files) {
    INFO(file);
    const std::string text = content(file);
    CHECK(std::visit([](const auto& read) { return read.text; }, read_question(text)) == text);
  }
}

TEST_CASE("a caret stands below the character", "[engine][query]") {
  CHECK(refusal("same(3)").excerpt() == "same(3)\n      ^");
  CHECK(refusal("").excerpt() == "\n^");
  // Characters are counted, not bytes; lines are not broken.
  CHECK(refusal("same(1,\t\n2) \xc3\xbc").excerpt() == "same(1,  2) \xc3\xbc\n            ^");
  CHECK(refusal("\xc3\xbc same(3)").excerpt() == "\xc3\xbc same(3)\n^");
  // Of a long text, what stands around the character.
  const std::string spaces(1000, ' ');
  CHECK(refusal(spaces + "smae" + spaces).excerpt() ==
        std::string(40, ' ') + "smae" + std::string(26, ' ') + '\n' + std::string(40, ' ') + '^');
}

TEST_CASE("each visit is remembered with where it is named", "[engine][query]") {
  const Query query = read_query("same(3, 12) and on(0, path_of(7))");
  REQUIRE(query.mentions.size() == 4);
  const std::size_t visits[] = {3, 12, 0, 7};
  const std::size_t at[] = {5, 8, 19, 30};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(query.mentions[i].visit == VisitId(visits[i]));
    CHECK(query.mentions[i].at == at[i]);
    CHECK(query.mentions[i].must_be_left == (i == 3));
  }
}

TEST_CASE("a route is asked for alone", "[engine][query]") {
  const auto route = std::get<RouteQuery>(read_question(" route( 12,3 ) "));
  CHECK((route.from == VisitId(12) && route.to == VisitId(3) && route.text == " route( 12,3 ) "));
  REQUIRE(route.mentions.size() == 2);
  CHECK((route.mentions[0].at == 8 && route.mentions[1].at == 11));
  CHECK(std::holds_alternative<Query>(read_question("same(0, 1)")));
  // Where only what is true or false may stand, it is not even offered.
  for (const std::string text : {"route(0, 1)", "rouet(0, 1)"}) try {
      read_query(text);
      FAIL("a query");
    } catch (const QueryError& error) {
      CHECK(std::string(error.what()).find("; expected same, differ,") != std::string::npos);
    }
}

TEST_CASE("any row of words is a query or refused", "[engine][query][property]") {
  const std::string words[] = {
      "same", "on",    "order",      "path_of",   "places", "steps", "and",         "or", "not",
      "(",    ")",     "(",          ")",         ",",      "=",     "!=",          "<",  "0",
      "12",   "route", "route(0,1)", "same(0,1)", "paths",  "!",     "order(0,1,2)"};
  RandomEngine engine(5);
  std::size_t read = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (std::size_t n = below(9, engine); n > 0; --n)
      text += words[below(std::size(words), engine)] + ' ';
    try {
      read_question(text);
      ++read;
    } catch (const QueryError& error) {
      REQUIRE(std::string(error.what()).starts_with("query, character "));
    }
  }
  CHECK(read > 50);
}
