#include "mapping/ssh_maps.hpp"

#include <utility>

#include "engine/ssh/ssh_certify.hpp"
#include "mapping/growing.hpp"
#include "mapping/trace_maps.hpp"

namespace asterism {

SshMaps::SshMaps(Experience experience, Theory theory, MapOptions options)
    : experience_(std::move(experience)),
      theory_(std::move(theory)),
      options_(std::move(options)),
      tree_(experience_, tree_options(theory_, options_)) {}

std::optional<std::string> SshMaps::find(const Stop& stop) {
  stopped_by_ = grow_all(tree_, steps(), options_, stop,
                         [&](std::size_t, std::size_t views) { return tree_.grow(views, stop); });
  if (tree_.views() == steps()) minimal_ = tree_.minimal();
  return stopped_by_;
}

SshReport SshMaps::report(const Stop&) const {
  SshReport report{{.trace = experience_.name, .options = options_}, experience_, minimal_};
  if (tree_.views() > 0) report.per_visit.emplace(tree_.per_view().begin(), tree_.per_view().end());
  report.stopped_by = stopped_by_;
  report.complete = !stopped_by_;
  if (tree_.views() == steps()) report.consistent = tree_.size();
  if (!minimal_.empty())
    report.minimal = {.paths = minimal_.front().number_of_paths(),
                      .places = minimal_.front().number_of_places(),
                      .count = minimal_.size(),
                      .certified = false};
  return report;
}

bool SshMaps::are_certified(const Stop& stop) const {
  return is_shown([&] { return certify(experience_, theory_, minimal_, stop); }, stop,
                  tree_.undecided() > 0);
}

std::optional<SshMapSource> SshMaps::all_in_order(const Stop&) const {
  return [this](const auto& write) { tree_.for_each(write); };
}

}  // namespace asterism
