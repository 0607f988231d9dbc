#include "core/trace.hpp"

#include <stdexcept>

namespace asterism {
namespace {

void require_gateway(const std::optional<std::size_t>& arm, const Star& star, bool is_required,
                     const std::string& where) {
  if (!arm) {
    if (is_required) throw std::invalid_argument(where + ": found nothing; expected an arm");
    return;
  }
  if (*arm >= star.size())
    throw std::invalid_argument(where + ": found arm " + std::to_string(*arm) +
                                "; expected one of " + std::to_string(star.size()));
  if (!star.has_gateway(*arm))
    throw std::invalid_argument(where + ": found " + star.name(*arm) +
                                ", which has no gateway; expected an arm with α = 1");
}

}  // namespace

void require_valid(const Trace& trace) {
  if (trace.visits.empty())
    throw std::invalid_argument("/visits: found none; expected at least one visit");
  for (std::size_t k = 0; k < trace.visits.size(); ++k) {
    const Visit& visit = trace.visits[k];
    const std::string where = "/visits/" + std::to_string(k);
    require_gateway(visit.entered_by, visit.star, k > 0, where + "/entered_by");
    require_gateway(visit.left_by, visit.star, k + 1 < trace.visits.size(), where + "/left_by");
  }
}

Trace part_of(const Trace& trace, std::size_t first, std::size_t last) {
  const auto visits = std::span(trace.visits).subspan(first, last - first);
  return {trace.name, {visits.begin(), visits.end()}, trace.extensions};
}

Trace cut(Trace trace, std::span<const std::size_t> before) {
  for (const std::size_t visit : before) {
    trace.visits[visit - 1].left_by.reset();
    trace.visits[visit].entered_by.reset();
  }
  return trace;
}

Trace reversed(const Trace& trace) {
  Trace result;
  result.name = trace.name;
  for (auto visit = trace.visits.rbegin(); visit != trace.visits.rend(); ++visit) {
    Visit back{.star = visit->star, .entered_by = visit->left_by, .left_by = visit->entered_by};
    back.true_place = visit->true_place;
    result.visits.push_back(std::move(back));
  }
  return result;
}

}  // namespace asterism
