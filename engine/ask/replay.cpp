#include "engine/ask/replay.hpp"

#include <stdexcept>
#include <string>

namespace asterism {
namespace {

std::string label(std::size_t number) {
  constexpr std::size_t letters = 26;
  std::string result(1, static_cast<char>('a' + number % letters));
  if (number >= letters) result += std::to_string(number / letters);
  return result;
}

}  // namespace

Replay::Replay(const MapList& maps) : table_(maps.trace), engine_(table_, maps.theory) {
  if (!maps.theory.axioms.is_shipped())
    throw std::invalid_argument("axioms other than the shipped ones need the solver");
  engine_.reset();
}

void Replay::go_to(std::span<const Arrival> map) {
  const std::vector<ArmId> named = table_.named(map);
  std::size_t shared = 0;
  while (shared < entered_.size() && entered_[shared].arm == named[shared]) ++shared;
  while (entered_.size() > shared) {
    engine_.leave(VisitId(entered_.size() - 1), entered_.back().arm, entered_.back().step);
    entered_.pop_back();
  }
  for (const VisitId k : IdRange(VisitId(shared), VisitId(named.size()))) {
    const ArmId arm = named[k.index()];
    const Step step = engine_.step(k, arm);
    engine_.enter(k, arm, step);
    entered_.push_back({arm, step});
  }
}

Star star_as_seen(const Star& star, std::size_t i) {
  std::vector<Arm> arms(star.size());
  std::size_t labels = 0;
  for (std::size_t step = 0; step < star.size(); ++step) {
    const std::size_t arm = star.clockwise(i, step);
    arms[step].has_gateway = star.has_gateway(arm);
    if (!arms[step].label.empty()) continue;
    Arm& opposite = arms[(star.opposite(arm) + star.size() - i) % star.size()];
    arms[step].label = opposite.label = label(labels++);
    opposite.sign = '-';
  }
  return Star(std::move(arms));
}

}  // namespace asterism
