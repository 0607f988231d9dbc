#include "benchmarks/asp_facts.hpp"

#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "core/topological_map.hpp"

namespace asterism {

std::string asp_facts(const Trace& trace) {
  std::string facts;
  const auto out = std::back_inserter(facts);
  std::vector<std::size_t> first_arm;  ///< of the place each visit founds
  std::size_t arms = 0;
  for (const Visit& visit : trace.visits) {
    first_arm.push_back(arms);
    arms += visit.star.size();
  }
  for (std::size_t k = 0; k < trace.visits.size(); ++k) {
    const Visit& visit = trace.visits[k];
    for (std::size_t i = 0; i < visit.star.size(); ++i)
      fmt::format_to(out, "arm({0},{1}). opposite({0},{2}).\n", first_arm[k] + i, k,
                     first_arm[k] + visit.star.opposite(i));
    if (k == 0) {
      if (visit.left_by) fmt::format_to(out, "start({}).\n", *visit.left_by);
      continue;
    }
    fmt::format_to(out, "visit({}).\n", k);
    const auto seen = visit.star.view(*visit.entered_by);
    for (std::size_t j = 0; j <= k; ++j) {
      const Star& star = trace.visits[j].star;
      for (std::size_t i = 0; i < star.size(); ++i) {
        if (star.view(i) != seen || (j == k && i != *visit.entered_by)) continue;
        fmt::format_to(out, "arrive({},{}).", k, first_arm[j] + i);
        if (visit.left_by)
          fmt::format_to(out, " depart({},{},{}).", k, first_arm[j] + i,
                         first_arm[j] + left_arm(visit, star, i));
        facts += '\n';
      }
    }
  }
  return facts;
}

}  // namespace asterism
