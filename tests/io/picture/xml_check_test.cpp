#include "tests/io/picture/xml_check.hpp"

#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("the check of XML tells good from bad", "[io]") {
  const char* good = GENERATE("<a/>", "<a><b c=\"d\" e=\"&amp;\"/>f &lt; g</a>\n",
                              "<!DOCTYPE html>\n<html>ä</html>");
  CHECK(is_well_formed(good));
  const char* bad = GENERATE("<a>", "</a>", "<a></b>", "<a><b></a></b>", "<a b=c/>", "<a b/>",
                             "<a b=\"c/>", "<a b=\"<\"/>", "<a b=\"c\"d=\"e\"/>", "a & b", "&nbsp;",
                             "a < b", "a > b", "<1/>", "<a");
  CHECK_FALSE(is_well_formed(bad));
}
