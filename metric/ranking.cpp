#include "metric/ranking.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

#include "metric/chi_squared.hpp"
#include "metric/layout.hpp"
#include "metric/layout_residual.hpp"
#include "metric/places_apart.hpp"

namespace asterism {
namespace {

PoseCovariance sum(const PoseCovariance& a, const PoseCovariance& b) {
  PoseCovariance result;
  std::ranges::transform(a, b, result.begin(), std::plus<>());
  return result;
}

// Where a visit was in the frame of its place: exactly there, at the first.
struct InPlace {
  Pose2 place_from_visit = {};
  PoseCovariance covariance = {};
};

// λ = L_{i-1} ⊕ d ⊕ (⊖ L_i), all errors told in the frame of the place reached. [BMK10, §7.3.1]
Displacement between_places(const InPlace& left, const Displacement& travelled,
                            const InPlace& reached) {
  const Pose2 moved = travelled.left_from_reached();
  const Pose2 whole = left.place_from_visit * moved * inverse(reached.place_from_visit);
  const PoseCovariance at_visit = sum(sum(travelled.covariance, reached.covariance),
                                      seen_from(inverse(moved), left.covariance));
  return make_displacement(whole, seen_from(reached.place_from_visit, at_visit));
}

std::size_t places_of(std::span<const Arrival> arrivals) {
  std::size_t places = 0;
  for (const Arrival& arrival : arrivals) places = std::max(places, arrival.place.index() + 1);
  return places;
}

std::size_t freedom(std::size_t visits, std::size_t places) { return 3 * (visits - places); }

}  // namespace

/// A walk down the tree that lays out what it passes, and keeps it for what branches off.
class Ranking::Search {
 public:
  /// A hypothesis laid out.
  struct Found {
    std::vector<Arrival> arrivals;
    std::vector<Pose2> layout_from_place;
    double misfit = 0;  ///< of layout and alignments together
  };

  Search(const Trace& trace, AlignmentSource alignments, const RankingOptions& options)
      : trace_(trace), alignments_(std::move(alignments)), least_tail_(options.least_tail) {
    for (const Visit& visit : trace.visits)
      discs_.push_back(options.on_one_floor ? disc_of(visit) : std::nullopt);
  }

  /// Adds the best hypotheses of so much doubt to `found`, which is sorted and never longer than
  /// `most`.
  void search(const Hypotheses& hypotheses, Doubt doubt, std::size_t most,
              std::vector<Found>& found) {
    if (most == 0) return;
    levels_.clear();
    displacements_.clear();
    hypotheses([&](std::span<const Arrival> arrivals) {
      const double worst = found.size() < most ? infinity : found.back().misfit;
      if (!follow(arrivals, doubt != Doubt::misfit, worst)) return;
      const Level& last = levels_.back();
      const double misfit = last.layout_misfit + last.alignment_misfit;
      if (misfit >= worst || doubt_of(last) != doubt) return;
      const auto after = std::ranges::upper_bound(found, misfit, {}, &Found::misfit);
      found.insert(after, {{arrivals.begin(), arrivals.end()}, last.layout_from_place, misfit});
      if (found.size() > most) found.pop_back();
    });
  }

  /// A map found, written out with its layout and what speaks against it.
  RankedMap ranked(const Found& found) {
    levels_.clear();
    displacements_.clear();
    RankedMap result{.map = make_map(trace_, found.arrivals)};
    for (const Arrival& arrival : found.arrivals) {
      arrive(arrival);
      if (levels_.back().alignment) {
        result.alignments.push_back(*levels_.back().alignment);
        result.alignments.back().place = arrival.place;
      }
    }
    result.displacements = displacements_;
    result.layout =
        lay_out(result.map.places.size(), displacements_, {.start = found.layout_from_place});
    ++layouts_;
    Level& last = levels_.back();
    last.layout_misfit = result.layout.chi_squared;
    const std::size_t degrees = freedom(found.arrivals.size(), result.map.places.size());
    result.misfit = {last.layout_misfit, degrees, chi_squared_tail(last.layout_misfit, degrees)};
    result.log_likelihood = -(last.layout_misfit + last.alignment_misfit) / 2;
    last.layout_from_place = result.layout.layout_from_place;
    result.shared_spots = spots_of(last);
    result.is_plausible = doubt_of(last) == Doubt::none;
    return result;
  }

  std::size_t layouts() const { return layouts_; }

 private:
  struct Level {
    Arrival arrival;
    std::vector<Pose2> layout_from_place = {};
    std::vector<std::size_t> first_visit = {};  ///< of each place
    InPlace visit = {};
    std::optional<Alignment> alignment = {};
    bool alignments_are_plausible = true;
    double layout_misfit = 0;
    double alignment_misfit = 0;
  };
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Doubt doubt_of(const Level& level) {
    if (!level.alignments_are_plausible ||
        level.layout_misfit > bound(levels_.size(), level.layout_from_place.size()))
      return Doubt::misfit;
    return spots_of(level).empty() ? Doubt::none : Doubt::shared_spot;
  }

  std::vector<SharedSpot> spots_of(const Level& level) const {
    std::vector<std::optional<PlaceDisc>> of_places;
    for (const std::size_t first : level.first_visit) of_places.push_back(discs_[first]);
    return shared_spots(level.layout_from_place, displacements_, of_places, least_tail_);
  }

  // The most that χ² may be, with so many degrees of freedom.
  double bound(std::size_t visits, std::size_t places) {
    const auto [known, fresh] = bounds_.try_emplace(freedom(visits, places));
    if (fresh)
      known->second = known->first == 0 ? infinity : chi_squared_of_tail(least_tail_, known->first);
    return known->second;
  }

  // Lays out a hypothesis, from where it leaves the last one. Gives up as soon as it is known to be
  // of no use.
  bool follow(std::span<const Arrival> arrivals, bool has_to_fit, double worst) {
    std::size_t same = 0;
    while (same < std::min(levels_.size(), arrivals.size()) &&
           levels_[same].arrival == arrivals[same])
      ++same;
    levels_.resize(same, Level{arrivals.front()});
    displacements_.resize(same > 0 ? same - 1 : 0, {PlaceId(0), PlaceId(0), {}});
    const double most = has_to_fit ? bound(arrivals.size(), places_of(arrivals)) : infinity;
    const auto is_useless = [&] {
      if (levels_.empty()) return false;
      const Level& last = levels_.back();
      return (has_to_fit && !last.alignments_are_plausible) || last.layout_misfit > most ||
             last.layout_misfit + last.alignment_misfit >= worst;
    };
    while (!is_useless()) {
      if (levels_.size() == arrivals.size()) return true;
      arrive(arrivals[levels_.size()]);
      lay_out_last();
    }
    return false;
  }

  // One visit more, its place where the displacement puts it if it is new.
  void arrive(const Arrival& arrival) {
    const std::size_t k = levels_.size();
    Level next{arrival};
    if (k > 0) {
      const Level& before = levels_.back();
      next.layout_from_place = before.layout_from_place;
      next.first_visit = before.first_visit;
      next.alignments_are_plausible = before.alignments_are_plausible;
      next.layout_misfit = before.layout_misfit;
      next.alignment_misfit = before.alignment_misfit;
    }
    const std::size_t place = arrival.place.index();
    const bool is_new = place == next.first_visit.size();
    if (!is_new) {
      next.alignment =
          alignments_(VisitId(next.first_visit[place]), VisitId(k), arrival.entered.value());
      next.visit = {next.alignment->place_from_visit, next.alignment->covariance};
      next.alignments_are_plausible &= next.alignment->misfit.tail_probability >= least_tail_;
      next.alignment_misfit += next.alignment->misfit.chi_squared;
    }
    if (k > 0) {
      const Level& before = levels_.back();
      const Displacement moved =
          between_places(before.visit, *trace_.visits[k].displacement, next.visit);
      displacements_.push_back({before.arrival.place, arrival.place, moved});
      if (is_new)
        next.layout_from_place.push_back(before.layout_from_place[before.arrival.place.index()] *
                                         moved.left_from_reached());
    } else {
      next.layout_from_place.push_back({});
    }
    if (is_new) next.first_visit.push_back(k);
    levels_.push_back(std::move(next));
  }

  // A new place fits its displacement as it is; a return pulls at all of the map.
  void lay_out_last() {
    Level& last = levels_.back();
    if (!last.alignment) return;
    const Layout layout = lay_out(last.layout_from_place.size(), displacements_,
                                  {.start = last.layout_from_place, .with_covariances = false});
    ++layouts_;
    last.layout_from_place = layout.layout_from_place;
    last.layout_misfit = layout.chi_squared;
  }

  const Trace& trace_;
  AlignmentSource alignments_;
  double least_tail_;
  std::vector<std::optional<PlaceDisc>> discs_;  ///< of each visit
  std::vector<Level> levels_;  ///< of the hypothesis laid out last, visit by visit
  std::vector<PlaceDisplacement> displacements_;
  std::map<std::size_t, double> bounds_;  ///< by degrees of freedom
  std::size_t layouts_ = 0;
};

Ranking::Ranking(const Trace& trace, AlignmentSource alignments, const RankingOptions& options)
    : options_(options), search_(std::make_unique<Search>(trace, std::move(alignments), options)) {
  for (std::size_t k = 1; k < trace.visits.size(); ++k) {
    if (!trace.visits[k].displacement) throw std::invalid_argument("a visit has no displacement");
    LayoutResidual{*trace.visits[k].displacement};
  }
}

Ranking::~Ranking() = default;

void Ranking::add(Hypotheses preferred_next) {
  add_best(preferred_next, Doubt::none, plausible_);
  classes_.push_back(std::move(preferred_next));
}

bool Ranking::is_settled() const { return plausible_.size() >= options_.models; }

std::vector<RankedMap> Ranking::best() {
  std::vector<RankedMap> result = plausible_;
  for (const Doubt doubt : {Doubt::shared_spot, Doubt::misfit})
    for (const Hypotheses& hypotheses : classes_) add_best(hypotheses, doubt, result);
  return result;
}

std::vector<RankedMap> Ranking::most_preferred() {
  std::vector<RankedMap> result;
  if (classes_.empty()) return result;
  for (const Doubt doubt : {Doubt::none, Doubt::shared_spot, Doubt::misfit})
    add_best(classes_.front(), doubt, result);
  return result;
}

void Ranking::add_best(const Hypotheses& hypotheses, Doubt doubt, std::vector<RankedMap>& ranked) {
  if (ranked.size() >= options_.models) return;
  std::vector<Search::Found> found;
  search_->search(hypotheses, doubt, options_.models - ranked.size(), found);
  for (const Search::Found& hypothesis : found) ranked.push_back(search_->ranked(hypothesis));
}

std::size_t Ranking::layouts() const { return search_->layouts(); }

}  // namespace asterism
