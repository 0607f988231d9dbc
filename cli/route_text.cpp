#include "cli/route_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>

#include "cli/query_parts.hpp"

namespace asterism {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_in_text = 3;
constexpr std::size_t most_in_json = 1000;

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
      const Visit& visit = trace.visits[query.from.index()];
      text +=
          ", " + visit.star.name(visit.star.clockwise(visit.entered_by.value_or(0), turn)) + ",";
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

std::uint64_t maps_with_shorter(const RouteAnswer& answer) {
  return std::accumulate(
      answer.shorter.begin(), answer.shorter.end(), answer.unlisted,
      [](std::uint64_t sum, const RouteAnswer::InSome& some) { return sum + some.maps; });
}

const char* verdict(const RouteAnswer& answer) {
  if (!answer.certain && !answer.is_shortest) return "undecided";
  switch (answer.modality()) {
    case Modality::certain:
      return "certain";
    case Modality::possible:
      return "possible";
    case Modality::impossible:
      return "impossible";
  }
  return "";
}

void print_shorter(const QueryCommand& command, const Trace& trace, const RouteQuery& query,
                   const RouteAnswer& answer) {
  const auto in_maps = [&](std::uint64_t maps) {
    return fmt::format("in {} {}", maps, noun(command, maps));
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

void print_route(const QueryCommand& command, const Trace& trace, const RouteQuery& query,
                 const RouteAnswer* answer, const std::optional<std::string>& stopped_by) {
  const std::string text = one_line(query.text);
  if (answer == nullptr) {
    fmt::print("{}: undecided, stopped by {}\n", text, *stopped_by);
    return;
  }
  const std::string all = fmt::format("{} {}", answer->of, noun(command, answer->of));
  if (answer->certain) {
    fmt::print("{}: certain, by {}, in {} of {}\n", text, travels(*answer->certain), answer->of,
               all);
    fmt::print("  {}{}\n", answer->certain->empty() ? "" : start(trace, query),
               words(trace, query, *answer->certain));
  } else {
    fmt::print("{}: {}, {}\n", text, verdict(*answer),
               answer->of == 0 ? "since there is no map" : "by no one route in all of " + all);
  }
  if (!answer->is_shortest)
    fmt::print("  undecided whether a shorter one is certain: there are too many to try\n");
  print_shorter(command, trace, query, *answer);
}

Json json_of(const RouteQuery& query, const RouteAnswer* answer) {
  Json result{{"query", query.text}, {"verdict", "undecided"}, {"of", nullptr},
              {"turns", nullptr},    {"is_shortest", nullptr}, {"shorter", nullptr},
              {"unlisted", nullptr}};
  if (answer == nullptr) return result;
  result["verdict"] = verdict(*answer);
  result["of"] = answer->of;
  if (answer->certain) {
    result["turns"] = *answer->certain;
    result["is_shortest"] = answer->is_shortest;
  }
  std::uint64_t unlisted = maps_with_shorter(*answer);
  result["shorter"] = Json::array();
  for (const RouteAnswer::InSome& route : answer->shorter) {
    if (result["shorter"].size() == most_in_json) break;
    result["shorter"].push_back({{"turns", route.route},
                                 {"maps", route.maps},
                                 {"witness", Json::parse(map_json(route.witness))}});
    unlisted -= route.maps;
  }
  result["unlisted"] = unlisted;
  return result;
}

/// The answer to query i, if there are answers.
const RouteAnswer* answer_of(const RouteReport& report, std::size_t i) {
  return report.answers ? &report.answers->at(i) : nullptr;
}

}  // namespace

bool RouteReport::is_undecided() const {
  return answers && std::ranges::any_of(*answers, [](const auto& one) { return !one.is_shortest; });
}

bool RouteReport::has_impossible() const {
  return answers && std::ranges::any_of(*answers, [](const auto& one) {
           return one.modality() == Modality::impossible;
         });
}

bool find_routes(const MapList& maps, const std::function<bool(std::uint64_t maps)>& go_on,
                 RouteReport& report) {
  std::vector<RouteAnswer> answers;
  for (const RouteQuery& query : report.queries) {
    auto answer = find_route(maps, query, go_on);
    if (!answer) return false;
    answers.push_back(std::move(*answer));
  }
  report.answers = std::move(answers);
  return true;
}

void print_routes(const QueryCommand& command, const Trace& trace, const RouteReport& report,
                  const std::optional<std::string>& stopped_by) {
  for (std::size_t i = 0; i < report.queries.size(); ++i)
    print_route(command, trace, report.queries[i], answer_of(report, i), stopped_by);
}

void write_routes(std::ostream& out, const RouteReport& report) {
  out << ",\n  \"routes\": [";
  for (std::size_t i = 0; i < report.queries.size(); ++i)
    out << (i == 0 ? "\n    " : ",\n    ")
        << json_of(report.queries[i], answer_of(report, i)).dump();
  out << ']';
}

}  // namespace asterism
