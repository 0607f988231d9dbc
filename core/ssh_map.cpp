#include "core/ssh_map.hpp"

#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace asterism {
namespace {

using Kind = Action::Kind;

/// Dstates in classes, each with a sign against the first of its class.
class SignedClasses {
 public:
  explicit SignedClasses(std::size_t size) : first_(size), reversed_(size), both_(size) {
    std::iota(first_.begin(), first_.end(), std::size_t{0});
  }

  /// Classes are few: all members of the later one are told.
  void join(std::size_t a, std::size_t b, bool reversed) {
    const std::size_t keep = std::min(first_[a], first_[b]);
    const std::size_t drop = std::max(first_[a], first_[b]);
    const bool turned = reversed_[a] ^ reversed_[b] ^ reversed;
    if (keep == drop) {
      if (turned) both_[keep] = true;
      return;
    }
    if (both_[drop]) both_[keep] = true;
    for (std::size_t d = 0; d < first_.size(); ++d) {
      if (first_[d] != drop) continue;
      first_[d] = keep;
      reversed_[d] = reversed_[d] ^ turned;
    }
  }

  std::size_t first(std::size_t d) const { return first_[d]; }
  SshMap::Direction direction(std::size_t d) const {
    if (both_[first_[d]]) return SshMap::Direction::both;
    return reversed_[d] ? SshMap::Direction::backward : SshMap::Direction::forward;
  }
  /// Numbers of the classes, by first dstate.
  std::vector<std::size_t> numbers() const {
    std::vector<std::size_t> result;
    std::size_t next = 0;
    for (std::size_t d = 0; d < first_.size(); ++d)
      result.push_back(first_[d] == d ? next++ : result[first_[d]]);
    return result;
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<bool> reversed_;
  std::vector<bool> both_;
};

std::size_t count_dstates(std::span<const DStateId> dstates) {
  std::size_t count = 0;
  for (const DStateId dstate : dstates) {
    if (dstate.index() > count)
      throw std::invalid_argument("dstates are not numbered by first view");
    if (dstate.index() == count) ++count;
  }
  return count;
}

/// Numbers travels by the segment they are along: that of the way back is the same.
std::vector<SshMap::Segment> segments_of(const Experience& experience,
                                         std::span<const DStateId> dstates) {
  std::map<DStateId, DStateId> around;
  for (std::size_t k = 0; k + 1 < dstates.size(); ++k)
    if (experience.actions[k].kind == Kind::turn_around) around.emplace(dstates[k], dstates[k + 1]);
  const auto way_back = [&](const SshMap::Segment& travel) -> std::optional<SshMap::Segment> {
    const auto from = around.find(travel.second);
    const auto to = around.find(travel.first);
    if (from == around.end() || to == around.end()) return std::nullopt;
    return SshMap::Segment{from->second, to->second};
  };

  std::vector<SshMap::Segment> result;
  std::map<SshMap::Segment, std::size_t> known;  // number of the pass that came by
  for (std::size_t k = 0; k + 1 < dstates.size(); ++k) {
    if (experience.actions[k].kind != Kind::travel) continue;
    const SshMap::Segment travel{dstates[k], dstates[k + 1]};
    bool is_new = true;
    // Back and forth, until a way that is not known, or that was come by before.
    for (std::optional<SshMap::Segment> way = travel; way; way = way_back(*way)) {
      const auto [entry, is_first] = known.emplace(*way, k);
      if (is_first) continue;
      is_new = entry->second == k;
      break;
    }
    if (is_new) result.push_back(travel);
  }
  return result;
}

}  // namespace

std::size_t SshMap::number_of_places() const {
  std::size_t result = 0;
  for (const PlaceId place : places) result = std::max(result, place.index() + 1);
  return result;
}

std::size_t SshMap::number_of_paths() const {
  std::size_t result = 0;
  for (const Along& along : paths) result = std::max(result, along.path.index() + 1);
  return result;
}

std::string_view sign_of(SshMap::Direction direction) {
  if (direction == SshMap::Direction::both) return "+-";
  return direction == SshMap::Direction::forward ? "+" : "-";
}

SshMap make_ssh_map(const Experience& experience, std::span<const DStateId> dstates) {
  if (dstates.size() > experience.views.size())
    throw std::invalid_argument("more dstates than views");
  const std::size_t count = count_dstates(dstates);
  SignedClasses places(count);
  SignedClasses paths(count);
  for (std::size_t k = 0; k + 1 < dstates.size(); ++k) {
    const std::size_t from = dstates[k].index();
    const std::size_t to = dstates[k + 1].index();
    const Kind kind = experience.actions[k].kind;
    if (kind != Kind::travel) places.join(from, to, false);
    if (kind != Kind::turn) paths.join(from, to, kind == Kind::turn_around);
  }

  SshMap map;
  map.dstates.assign(dstates.begin(), dstates.end());
  for (const std::size_t number : places.numbers()) map.places.emplace_back(number);
  const std::vector<std::size_t> path_numbers = paths.numbers();
  for (std::size_t d = 0; d < count; ++d)
    map.paths.push_back({PathId(path_numbers[d]), paths.direction(d)});
  map.segments = segments_of(experience, dstates);
  return map;
}

}  // namespace asterism
