#include "engine/arm_table.hpp"

#include <stdexcept>

#include "core/error.hpp"

namespace asterism {
namespace {

constexpr std::size_t max_arms = (1 << 21) - 1;
/// The search goes as deep as there are visits, on a stack of 8 MiB.
constexpr std::size_t max_visits = 20'000;

}  // namespace

ArmTable::ArmTable(const Trace& trace, std::size_t visits) {
  for (std::size_t k = 0; k < visits; ++k) append(trace.visits.at(k));
}

void ArmTable::append(const Visit& visit) {
  const std::size_t k = visits();
  const std::string where = "visit " + std::to_string(k);
  if (k > 0 && !trace_.visits.back().left_by)
    throw std::invalid_argument(where + ": the visit before it was not left");
  if (k > 0 && !visit.entered_by)
    throw std::invalid_argument(where + ": found no arm entered by; expected one");
  for (const auto& arm : {visit.entered_by, visit.left_by})
    if (arm && !visit.star.has_gateway(*arm))
      throw std::invalid_argument(where + ": found arm " + visit.star.name(*arm) +
                                  " without gateway; expected α = 1");

  if (k >= max_visits)
    throw Error("trace: found more than " + std::to_string(max_visits) + " visits; expected fewer");
  if (arms_.size() + visit.star.size() > max_arms)
    throw Error("trace: found more than " + std::to_string(max_arms) + " arms; expected fewer");
  const auto first_arm = static_cast<ArmIndex>(arms_.size());
  const auto star_size = static_cast<ArmIndex>(visit.star.size());
  for (ArmIndex i = 0; i < star_size; ++i) {
    const auto number = view_numbers_.emplace(visit.star.view(i), view_numbers_.size()).first;
    arms_.push_back({static_cast<ArmIndex>(k),
                     first_arm + static_cast<ArmIndex>(visit.star.opposite(i)), number->second,
                     first_arm + star_size, star_size, visit.star.has_gateway(i)});
  }
  const auto entered = first_arm + static_cast<ArmIndex>(visit.entered_by.value_or(0));
  const auto first_gateway = static_cast<ArmIndex>(gateways_.size());
  for (ArmIndex arm = first_arm; arm < first_arm + star_size; ++arm)
    if (has_gateway(arm)) gateways_.push_back(arm);
  visits_.push_back({.first_arm = first_arm,
                     .star_size = star_size,
                     .entered = entered,
                     .seen = view(entered),
                     .left_steps = 0,
                     .first_gateway = first_gateway,
                     .gateways = static_cast<ArmIndex>(gateways_.size()) - first_gateway});
  for (ArmIndex step = 1; step <= star_size; ++step)
    if (const ArmIndex arm = clockwise(entered, step); has_gateway(arm))
      gateways_after_entered_.push_back(arm);
  trace_.visits.push_back(visit);
  set_left_steps();
}

void ArmTable::keep_first(std::size_t visits) {
  if (visits >= this->visits()) return;
  arms_.resize(visits_[visits].first_arm);
  gateways_.resize(visits_[visits].first_gateway);
  gateways_after_entered_.resize(visits_[visits].first_gateway);
  visits_.resize(visits);
  trace_.visits.erase(trace_.visits.begin() + static_cast<std::ptrdiff_t>(visits),
                      trace_.visits.end());
}

void ArmTable::leave(std::size_t left_by) {
  Visit& last = trace_.visits.back();
  if (left_by >= last.star.size() || !last.star.has_gateway(left_by))
    throw std::invalid_argument("the arm to leave by has no gateway");
  last.left_by = left_by;
  set_left_steps();
}

void ArmTable::set_left_steps() {
  const Visit& visit = trace_.visits.back();
  if (!visit.left_by) return;
  const std::size_t size = visit.star.size();
  visits_.back().left_steps =
      static_cast<ArmIndex>((*visit.left_by + size - visit.entered_by.value_or(0)) % size);
}

std::vector<Arrival> ArmTable::arrivals(std::span<const ArmIndex> named) const {
  std::vector<Arrival> result;
  std::vector<std::size_t> place_of_visit;  // by first visit
  result.reserve(named.size());
  place_of_visit.reserve(named.size());
  std::size_t places = 0;
  for (std::size_t k = 0; k < named.size(); ++k) {
    const ArmIndex first_visit = visit_of(named[k]);
    place_of_visit.push_back(first_visit == k ? places++ : place_of_visit[first_visit]);
    std::optional<std::size_t> entered = named[k] - first_arm(first_visit);
    if (!trace_.visits[k].entered_by) entered.reset();
    result.push_back({PlaceId(place_of_visit[k]), entered});
  }
  return result;
}

std::vector<ArmIndex> ArmTable::named(std::span<const Arrival> arrivals) const {
  std::vector<ArmIndex> result;
  std::vector<std::size_t> first_visit;  // of each place
  for (std::size_t k = 0; k < arrivals.size(); ++k) {
    const auto& [place, entered] = arrivals[k];
    if (place.index() == first_visit.size()) first_visit.push_back(k);
    result.push_back(first_arm(first_visit.at(place.index())) +
                     static_cast<ArmIndex>(entered.value_or(0)));
  }
  return result;
}

}  // namespace asterism
