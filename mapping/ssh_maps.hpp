#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axioms/theory.hpp"
#include "core/map_report.hpp"
#include "core/stop.hpp"
#include "engine/ssh/ssh_tree.hpp"
#include "io/json/maps_file.hpp"

namespace asterism {

/// The maps of an experience of the basic SSH, listed by the tree, as TraceMaps has those of a
/// trace of visits. For one thread at a time.
class SshMaps {
 public:
  /// @throws std::invalid_argument as SshTree
  SshMaps(Experience experience, Theory theory, MapOptions options);

  /// Lists them.  @return what stopped it, if anything did
  std::optional<std::string> find(const Stop& stop = {});
  /// What is known by now, the minimal models not certified.
  SshReport report(const Stop& stop = {}) const;
  /// Whether the solver certifies the minimal models, in the time that `stop` leaves.
  /// @throws std::logic_error if it refutes them
  bool are_certified(const Stop& stop) const;
  /// All of them in the order of reports, for as long as this is there.
  std::optional<SshMapSource> all_in_order(const Stop& stop = {}) const;

  const Experience& experience() const { return experience_; }
  std::size_t steps() const { return experience_.views.size(); }
  const Theory& theory() const { return theory_; }

 private:
  Experience experience_;
  Theory theory_;
  MapOptions options_;
  SshTree tree_;
  std::vector<SshMap> minimal_ = {};
  std::optional<std::string> stopped_by_ = {};
};

}  // namespace asterism
