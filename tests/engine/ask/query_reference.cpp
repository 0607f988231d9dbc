#include "tests/engine/ask/query_reference.hpp"

#include <algorithm>
#include <numeric>

namespace asterism {
namespace {

/// Makes two classes one, named by the lesser number.
void unite(std::vector<std::size_t>& classes, std::size_t a, std::size_t b) {
  const auto [kept, gone] = std::minmax(classes[a], classes[b]);
  std::replace(classes.begin(), classes.end(), std::size_t{gone}, std::size_t{kept});
}

}  // namespace

QueryReference::QueryReference(const TopologicalMap& map) : map_(map) {
  for (std::size_t p = 0; p < map.places.size(); ++p)
    for (std::size_t arm = 0; arm < map.places[p].star.size(); ++arm)
      arms_.push_back({PlaceId(p), arm});
  directed_.resize(arms_.size());
  std::iota(directed_.begin(), directed_.end(), std::size_t{0});
  for (const auto& [a, b] : map.segments) {
    unite(directed_, number(a), number(opposite(b)));
    unite(directed_, number(b), number(opposite(a)));
  }
  path_ = directed_;
  for (const PlaceArm arm : arms_) unite(path_, number(arm), number(opposite(arm)));

  for (const auto& [a, b] : map.segments) {
    before_.insert({directed_[number(a)], a.place.index(), b.place.index()});
    before_.insert({directed_[number(b)], b.place.index(), a.place.index()});
  }
  for (bool added = true; added;) {
    added = false;
    for (const auto& [path, p, q] : before_)
      for (const auto& [other_path, r, s] : before_)
        if (path == other_path && q == r) added |= before_.insert({path, p, s}).second;
  }
}

std::size_t QueryReference::number(PlaceArm arm) const {
  return static_cast<std::size_t>(std::ranges::find(arms_, arm) - arms_.begin());
}

PlaceArm QueryReference::opposite(PlaceArm arm) const {
  const Star& star = map_.places[arm.place.index()].star;
  for (std::size_t i = 0; i < star.size(); ++i)
    if (i != arm.arm && star.arm(i).label == star.arm(arm.arm).label) return {arm.place, i};
  return arm;
}

bool QueryReference::is_on(std::size_t place, std::size_t path) const {
  return std::ranges::any_of(arms_, [&](PlaceArm arm) {
    return arm.place.index() == place && path_[number(arm)] == path;
  });
}

bool QueryReference::adjacent(std::size_t i, std::size_t j) const {
  return std::ranges::any_of(map_.segments, [&](const auto& segment) {
    return std::minmax(segment.first.place.index(), segment.second.place.index()) ==
           std::minmax(place(i), place(j));
  });
}

bool QueryReference::on_path(std::size_t i, std::size_t j) const {
  return std::ranges::any_of(
      path_, [&](std::size_t path) { return is_on(place(i), path) && is_on(place(j), path); });
}

bool QueryReference::on(std::size_t i, std::size_t j) const {
  return is_on(place(i), path_[number({map_.visits[j], *map_.left[j]})]);
}

bool QueryReference::order(std::size_t i, std::size_t j, std::size_t k) const {
  return std::ranges::any_of(directed_, [&](std::size_t path) {
    return before_.contains({path, place(i), place(j)}) &&
           before_.contains({path, place(j), place(k)});
  });
}

bool QueryReference::same_path(std::size_t i, std::size_t j) const {
  return path_[number({map_.visits[i], *map_.left[i]})] ==
         path_[number({map_.visits[j], *map_.left[j]})];
}

std::size_t QueryReference::steps(std::size_t i, std::size_t j) const {
  std::set<std::size_t> reached{place(i)};
  std::size_t steps = 0;
  while (!reached.contains(place(j))) {
    ++steps;
    std::set<std::size_t> further = reached;
    for (const auto& [a, b] : map_.segments) {
      if (reached.contains(a.place.index())) further.insert(b.place.index());
      if (reached.contains(b.place.index())) further.insert(a.place.index());
    }
    reached = std::move(further);
  }
  return steps;
}

std::size_t QueryReference::paths() const {
  return std::set<std::size_t>(path_.begin(), path_.end()).size();
}

}  // namespace asterism
