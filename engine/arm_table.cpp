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
  const std::size_t first = arms_.size();
  const std::size_t size = visit.star.size();
  const auto small = [](std::size_t number) { return static_cast<std::uint32_t>(number); };
  for (std::size_t i = 0; i < size; ++i) {
    const ViewId view =
        view_numbers_.emplace(visit.star.view(i), view_numbers_.size()).first->second;
    arms_.push_back({VisitId(k), ArmId(first + visit.star.opposite(i)), view, small(first + size),
                     small(size), visit.star.has_gateway(i)});
  }
  const ArmId entered(first + visit.entered_by.value_or(0));
  const std::size_t first_gateway = gateways_.size();
  for (const ArmId arm : IdRange(ArmId(first), ArmId(first + size)))
    if (has_gateway(arm)) gateways_.push_back(arm);
  visits_.push_back({.first_arm = ArmId(first),
                     .star_size = small(size),
                     .entered = entered,
                     .seen = view(entered),
                     .left_steps = 0,
                     .first_gateway = small(first_gateway),
                     .gateways = small(gateways_.size() - first_gateway)});
  for (std::size_t step = 1; step <= size; ++step)
    if (const ArmId arm = clockwise(entered, step); has_gateway(arm))
      gateways_after_entered_.push_back(arm);
  trace_.visits.push_back(visit);
  set_left_steps();
}

void ArmTable::keep_first(std::size_t visits) {
  if (visits >= this->visits()) return;
  const VisitFacts& gone = visits_[VisitId(visits)];
  gateways_.resize(gone.first_gateway, no_arm);
  gateways_after_entered_.resize(gone.first_gateway, no_arm);
  arms_.keep_first(gone.first_arm.index());
  visits_.keep_first(visits);
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
  visits_[VisitId(visits() - 1)].left_steps =
      static_cast<std::uint32_t>((*visit.left_by + size - visit.entered_by.value_or(0)) % size);
}

std::vector<Arrival> ArmTable::arrivals(std::span<const ArmId> named) const {
  std::vector<Arrival> result;
  result.reserve(named.size());
  std::size_t places = 0;
  for (const ArmId arm : named) {
    const VisitId first_visit = visit_of(arm);
    const std::size_t k = result.size();
    const PlaceId place =
        first_visit.index() == k ? PlaceId(places++) : result[first_visit.index()].place;
    std::optional<std::size_t> entered = position(arm);
    if (!trace_.visits[k].entered_by) entered.reset();
    result.push_back({place, entered});
  }
  return result;
}

std::vector<ArmId> ArmTable::named(std::span<const Arrival> arrivals) const {
  std::vector<ArmId> result;
  std::vector<VisitId> first_visit;  // of each place
  for (const auto& [place, entered] : arrivals) {
    if (place.index() == first_visit.size()) first_visit.emplace_back(result.size());
    result.push_back(arm(first_visit.at(place.index()), entered.value_or(0)));
  }
  return result;
}

}  // namespace asterism
