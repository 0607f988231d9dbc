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
  return std::tie(o.theory, o.check, o.certify_s, o.max_hypotheses, o.time_limit_s, o.all);
}

auto members(const PlaceDisplacement& d) { return std::tie(d.from, d.to, d.displacement); }

auto members(const Misfit& m) {
  return std::tie(m.chi_squared, m.degrees_of_freedom, m.tail_probability);
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

bool equal(const Alignment& a, const Alignment& b) {
  const auto plain = [](const Alignment& x) {
    return std::tie(x.visit, x.place, x.place_from_visit, x.covariance, x.matched_walls);
  };
  return plain(a) == plain(b) && equal(a.misfit, b.misfit);
}

bool equal(const SharedSpot& a, const SharedSpot& b) {
  const auto plain = [](const SharedSpot& x) { return std::tie(x.one, x.other, x.distance_m); };
  return plain(a) == plain(b) && equal(a.misfit, b.misfit);
}

bool equal(const RankedMap& a, const RankedMap& b) {
  const auto plain = [](const RankedMap& r) {
    return std::tie(r.layout.layout_from_place, r.layout.covariances, r.layout.chi_squared,
                    r.log_likelihood, r.is_plausible);
  };
  return plain(a) == plain(b) && equal(a.map, b.map) && equal(a.misfit, b.misfit) &&
         equal(a.displacements, b.displacements) &&
         std::ranges::equal(a.shared_spots, b.shared_spots,
                            [](const SharedSpot& x, const SharedSpot& y) { return equal(x, y); }) &&
         std::ranges::equal(a.alignments, b.alignments,
                            [](const Alignment& x, const Alignment& y) { return equal(x, y); });
}

template <class Part>
bool all_equal(const std::vector<Part>& a, const std::vector<Part>& b) {
  return std::ranges::equal(a, b, [](const Part& x, const Part& y) { return equal(x, y); });
}

}  // namespace

bool same(const Trace& a, const Trace& b) {
  return a.name == b.name && a.extensions == b.extensions && a.visits == b.visits;
}

bool same(const MapReport& a, const MapReport& b) {
  const auto plain = [](const MapReport& r) {
    return std::tie(r.trace, r.consistent, r.per_visit, r.complete, r.stopped_by,
                    r.explained_visits);
  };
  return plain(a) == plain(b) && equal(a.options, b.options) && equal(a.minimal, b.minimal) &&
         all_equal(a.maps, b.maps) && all_equal(a.ranked, b.ranked);
}

bool same(const SshReport& a, const SshReport& b) {
  const auto plain = [](const SshReport& r) {
    return std::tie(r.trace, r.experience, r.consistent, r.per_visit, r.complete, r.stopped_by,
                    r.maps);
  };
  return plain(a) == plain(b) && equal(a.options, b.options) && equal(a.minimal, b.minimal);
}

}  // namespace asterism
