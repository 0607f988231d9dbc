#include "tests/io/same.hpp"

#include <algorithm>
#include <tuple>

namespace asterism {
namespace {

auto members(const TopologicalMap::Place& p) { return std::tie(p.star, p.first_visit); }

auto members(const TopologicalMap::Path& p) { return std::tie(p.places, p.ends); }

auto members(const MapReport::Minimal& m) {
  return std::tie(m.paths, m.places, m.count, m.certified);
}

auto members(const MapOptions& o) {
  return std::tie(o.planar, o.check, o.axioms, o.optional_axioms, o.preference, o.certify_s,
                  o.max_hypotheses, o.time_limit_s, o.all);
}

template <class Part>
bool equal(const Part& a, const Part& b) {
  return members(a) == members(b);
}

template <class Part>
bool equal(const std::optional<Part>& a, const std::optional<Part>& b) {
  return a.has_value() == b.has_value() && (!a || equal(*a, *b));
}

template <class Part>
bool equal(const std::vector<Part>& a, const std::vector<Part>& b) {
  return std::ranges::equal(a, b, [](const Part& x, const Part& y) { return equal(x, y); });
}

bool equal(const TopologicalMap& a, const TopologicalMap& b) {
  const auto plain = [](const TopologicalMap& m) {
    return std::tie(m.visits, m.entered, m.left, m.segments);
  };
  return plain(a) == plain(b) && equal(a.places, b.places) && equal(a.paths, b.paths);
}

}  // namespace

bool same(const Trace& a, const Trace& b) {
  return a.name == b.name && a.extensions == b.extensions && a.visits == b.visits;
}

bool same(const MapReport& a, const MapReport& b) {
  const auto plain = [](const MapReport& r) {
    return std::tie(r.trace, r.consistent, r.per_visit, r.complete, r.stopped_by);
  };
  return plain(a) == plain(b) && equal(a.options, b.options) && equal(a.minimal, b.minimal) &&
         std::ranges::equal(a.maps, b.maps, [](const TopologicalMap& x, const TopologicalMap& y) {
           return equal(x, y);
         });
}

}  // namespace asterism
