#include "tests/io/same.hpp"

#include <algorithm>
#include <tuple>

namespace asterism {
namespace {

auto members(const Displacement& d) { return std::tie(d.x_m, d.y_m, d.heading_rad, d.covariance); }

auto members(const MeasuredGateway& g) {
  return std::tie(g.arm, g.x_m, g.y_m, g.heading_rad, g.width_m);
}

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

bool equal(const Visit& a, const Visit& b) {
  const auto plain = [](const Visit& v) {
    return std::tie(v.star, v.entered_by, v.left_by, v.scans, v.stamps_s, v.lpm, v.true_place,
                    v.extensions);
  };
  return plain(a) == plain(b) && equal(a.displacement, b.displacement) &&
         equal(a.gateways, b.gateways);
}

bool equal(const TopologicalMap& a, const TopologicalMap& b) {
  const auto plain = [](const TopologicalMap& m) {
    return std::tie(m.visits, m.entered, m.left, m.segments);
  };
  return plain(a) == plain(b) && equal(a.places, b.places) && equal(a.paths, b.paths);
}

}  // namespace

bool same(const Trace& a, const Trace& b) {
  return a.name == b.name && a.extensions == b.extensions &&
         std::ranges::equal(a.visits, b.visits,
                            [](const Visit& x, const Visit& y) { return equal(x, y); });
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
