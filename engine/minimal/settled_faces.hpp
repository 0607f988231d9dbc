#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/id_vector.hpp"
#include "engine/arm_table.hpp"
#include "engine/minimal/identified_arms.hpp"
#include "engine/minimal/settled_places.hpp"
#include "engine/minimal/stamped_set.hpp"

namespace asterism {

/// The faces of the plane between settled places and the travels that join them.
///
/// A settled place's gateway to nowhere settled lies in one of them, and so does whatever turns out
/// to be behind it: two such gateways of connected places can be joined without a crossing iff they
/// lie in one face.                                                                   [theory §7]
class SettledFaces {
 public:
  explicit SettledFaces(const ArmTable& table);

  /// Numbers the faces of what is settled now.
  /// @return whether the settled places can be drawn in the plane:
  ///         V - E + F = 2 of each connected part
  bool number(const IdentifiedArms& identified, const SettledPlaces& settled);

  /// Whether the place of x, joined to settled places, can be that of y, a settled one, without
  /// crossing a travel between settled places.
  /// @pre the faces are numbered
  bool may_stand_at(ArmId x, ArmId y, const IdentifiedArms& identified,
                    const SettledPlaces& settled) const;
  /// Whether the place of x can be another than all that are settled, without such a crossing.
  /// @pre the faces are numbered
  bool may_stand_apart(ArmId x, const IdentifiedArms& identified,
                       const SettledPlaces& settled) const;

 private:
  /// Walks once round each face.  @return number of ends of travels between settled places
  std::size_t number_faces(const IdentifiedArms& identified, const SettledPlaces& settled);
  void number_parts(const IdentifiedArms& identified, const SettledPlaces& settled);
  /// Whether what leads to these two can only meet by a crossing.
  bool are_apart(ArmId x, ArmId y) const {
    return face_[x] != face_[y] && part_[table_.visit_of(x)] == part_[table_.visit_of(y)];
  }

  const ArmTable& table_;
  IdVector<ArmId, std::uint32_t>
      face_;  ///< of a settled place's gateway without settled end: where
  IdVector<VisitId, std::uint32_t> part_;  ///< of a settled place: what is connected
  std::uint32_t faces_ = 0;
  std::uint32_t parts_ = 0;
  StampedSet<ArmId> walked_;     ///< arms whose face has been walked round
  StampedSet<VisitId> reached_;  ///< visits whose part is known
  std::vector<VisitId> to_do_;
};

}  // namespace asterism
