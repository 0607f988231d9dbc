#include "engine/ask/query_reader.hpp"
#include "engine/tree/map_tree.hpp"
#include "tests/support/fuzz.hpp"

namespace {

using namespace asterism;

/// All maps of five visits to crossings, which look alike.
const MapTree& crossings() {
  static const MapTree tree = [] {
    const Star crossing = Star::parse("a+1 b+1 a-1 b-1");
    MapTree result;
    for (const std::size_t left : {0U, 1U, 3U, 0U, 3U})
      static_cast<void>(result.extend({.star = crossing, .entered_by = 2, .left_by = left}));
    return result;
  }();
  return tree;
}

/// A route leads there in all these maps, since the trace's own way does.
void require_route(const RouteQuery& query) {
  const auto answer =
      accepted("query, character ", [&] { return *find_route(crossings(), query, false); });
  if (!answer) return;
  const std::size_t from = query.from.index();
  const std::size_t to = query.to.index();
  require(answer->of == crossings().size() && answer->is_shortest && answer->certain.has_value());
  require(answer->certain->size() <= (from < to ? to - from : from - to));
}

Answer answer_to(const Query& query) { return ask(crossings(), {&query, 1}, false)->front(); }

}  // namespace

/// Any bytes are a query or refused. A query names visits that are there, or is refused then; its
/// opposite holds where it does not. A route has no opposite. What is an assumption is a query too.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz_input(data, size);
  const auto question = accepted("query, character ", [&] { return read_question(text); });
  const auto stated = accepted("assumption, character ", [&] { return read_assumption(text); });
  require(question || !stated);
  if (stated)
    require(read_assumption(text_of(stated->assumption)).assumption == stated->assumption);
  if (!question) return 0;
  if (const auto* route = std::get_if<RouteQuery>(&*question)) {
    require_route(*route);
    return 0;
  }
  const Query* query = &std::get<Query>(*question);
  const auto answer = accepted("query, character ", [&] { return answer_to(*query); });
  const auto opposite =
      accepted("query, character ", [&] { return read_query("not (" + text + ")"); });
  if (!answer || !opposite) return 0;  // it may be too long or too deep
  require(answer->of == crossings().size());
  require(answer_to(*opposite).holds == answer->of - answer->holds);
  return 0;
}
