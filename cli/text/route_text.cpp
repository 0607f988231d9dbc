#include "cli/text/route_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/text/query_text.hpp"

namespace asterism {
namespace {

constexpr std::size_t most_in_text = 3;

std::string ordinal(std::size_t number) {
  const bool is_teen = number / 10 % 10 == 1;
  const std::size_t last = is_teen ? 0 : number % 10;
  return fmt::format("{}{}", number, last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

std::string travels(const Turns& route) {
  return fmt::format("{} travel{}", route.size(), route.size() == 1 ? "" : "s");
}

/// "leave by the 2nd arm clockwise, v-, travel; by the 1st, travel".
std::string words(const Trace& trace, const RouteQuery& query, const Turns& route) {
  if (route.empty()) return "stay: it is there";
  std::string text;
  for (const std::size_t turn : route) {
    const bool is_first = text.empty();
    text += is_first ? "leave by the " : "; by the ";
    text += turn == 0 ? "arm come in by"
                      : fmt::format("{}{}", ordinal(turn), is_first ? " arm clockwise" : "");
    if (is_first) {  // of the places to come, the arms have names in single maps only
      text += ", " + first_arm(trace.visits[query.from.index()], route) + ",";
    }
    text += is_first ? " travel" : ", travel";
  }
  return text;
}

/// "come in by v+, ".
std::string start(const Trace& trace, const RouteQuery& query) {
  const Visit& visit = trace.visits[query.from.index()];
  return fmt::format("{}come in by {}, ", visit.entered_by ? "" : "as if ",
                     visit.star.name(visit.entered_by.value_or(0)));
}

void print_shorter(const AnswersReport& report, const Trace& trace, const RouteQuery& query,
                   const RouteAnswer& answer) {
  const auto in_maps = [&](std::uint64_t maps) {
    return fmt::format("in {} {}", maps, noun(report, maps));
  };
  std::uint64_t left = maps_with_shorter(answer);
  if (left == 0) return;
  fmt::print("  {} leads there {}; of each map, the first by turns:\n",
             answer.certain ? "a shorter one" : "a route", in_maps(left));
  for (std::size_t i = 0; i < std::min(most_in_text, answer.shorter.size()); ++i) {
    const RouteAnswer::InSome& some = answer.shorter[i];
    left -= some.maps;
    fmt::print("  {}, {}: {}\n", travels(some.route), in_maps(some.maps),
               words(trace, query, some.route));
    fmt::print("    such as that with visits at places {}\n", visits_text(some.witness));
  }
  if (left > 0) fmt::print("  others, {}\n", in_maps(left));
}

void print_route(const AnswersReport& report, const Trace& trace, const RouteQuery& query,
                 const RouteAnswer* answer) {
  const std::string text = one_line(query.text);
  if (answer == nullptr) {
    fmt::print("{}: undecided, stopped by {}\n", text, *report.stopped_by);
    return;
  }
  const std::string all = fmt::format("{} {}", answer->of, noun(report, answer->of));
  if (answer->certain) {
    fmt::print("{}: certain, by {}, in {} of {}\n", text, travels(*answer->certain), answer->of,
               all);
    fmt::print("  {}{}\n", answer->certain->empty() ? "" : start(trace, query),
               words(trace, query, *answer->certain));
  } else {
    fmt::print("{}: {}, {}\n", text, verdict_of(*answer),
               answer->of == 0 ? "since there is no map" : "by no one route in all of " + all);
  }
  if (!answer->is_shortest)
    fmt::print("  undecided whether a shorter one is certain: there are too many to try\n");
  print_shorter(report, trace, query, *answer);
}

/// The answer to query i, if there are answers.
const RouteAnswer* answer_of(const AnswersReport::Routes& routes, std::size_t i) {
  return routes.answers ? &routes.answers->at(i) : nullptr;
}

}  // namespace

void print_routes(const AnswersReport& report, const Trace& trace) {
  const AnswersReport::Routes& routes = report.routes;
  for (std::size_t i = 0; i < routes.queries.size(); ++i)
    print_route(report, trace, routes.queries[i], answer_of(routes, i));
}

}  // namespace asterism
