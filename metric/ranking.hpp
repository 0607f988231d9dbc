#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/ranked_map.hpp"
#include "core/topological_map.hpp"
#include "core/trace.hpp"

namespace asterism {

/// L_i where a hypothesis has a visit return to the place of visit `first`, in by this arm of that
/// visit's star.
using AlignmentSource = std::function<Alignment(VisitId first, VisitId visit, std::size_t entered)>;

/// How many maps are ranked, and what is plausible.
struct RankingOptions {
  std::size_t models = 5;    ///< ranked; the others are only known to come after them
  double least_tail = 1e-3;  ///< of χ²: what is rarer than that by chance is implausible
  bool on_one_floor = true;  ///< so that no two places are on one spot
};

/// Ranks the hypotheses that explain a trace: first those whose layout and alignments are
/// plausible and whose places lie apart, among these the preferred, ties by log-likelihood; then,
/// alike, those where only two places share a spot; then the others. None is dropped: what is not
/// reported ranks below what is.
///                                                                                    [theory §12]
///
/// The hypotheses of one preference come together, in the order of the tree: then those that agree
/// on the first visits share the layout of these, and what misfits them already is not laid out any
/// further, since a sum of squares only grows. All of one preference have as many places, hence as
/// many degrees of freedom, so that the bound on χ² is the same for all.
/// For one thread at a time: it keeps the layouts it has solved for.
class Ranking {
 public:
  /// @param trace       must outlive this
  /// @param alignments  called for returns as they are met; likewise one thread at a time
  /// @throws std::invalid_argument if a visit but the first has no displacement, or one whose
  ///         covariance is not positive definite
  Ranking(const Trace& trace, AlignmentSource alignments, const RankingOptions& options = {});
  ~Ranking();

  /// What a class of hypotheses is: calls its argument with each, in the order of the tree.
  using Hypotheses = std::function<void(const std::function<void(std::span<const Arrival>)>&)>;

  /// Takes the hypotheses of the next preference, and keeps them: best() may ask for them again.
  /// Once it is settled there is no need to.
  void add(Hypotheses preferred_next);
  /// As many plausible ones as are reported are known: none of the hypotheses to come is among
  /// them.
  bool is_settled() const;

  /// The best, in order. Lays out implausible ones only where plausible ones are too few.
  std::vector<RankedMap> best();
  /// The best of the first preference alone, plausible or not.
  std::vector<RankedMap> most_preferred();

  /// How often a layout was solved for.
  std::size_t layouts() const;

 private:
  class Search;
  /// What speaks against a hypothesis; they are ranked in this order.
  enum class Doubt {
    none,         ///< it is plausible
    shared_spot,  ///< all measures fit, but two places lie on one spot
    misfit        ///< layout or alignments do not fit
  };

  void add_best(const Hypotheses& hypotheses, Doubt doubt, std::vector<RankedMap>& ranked);

  RankingOptions options_;
  std::unique_ptr<Search> search_;
  std::vector<RankedMap> plausible_;
  std::vector<Hypotheses> classes_;
};

}  // namespace asterism
