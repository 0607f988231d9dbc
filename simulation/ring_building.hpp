#pragma once

#include "core/random.hpp"
#include "simulation/building.hpp"
#include "simulation/walk.hpp"

namespace asterism {

/// A building like that of the ACES log: a ring of corridors, 44 m × 39 m, and a cross in it whose
/// corridors meet in a round hall through necks. Places are N, NE, E, SE, S, SW, W, NW, C, from 0.
///
///   ... NW --- N --- NE ...     two corners (L), six T's, the cross (+): at NW and NE the corridor
///       |      |      |         goes on for farther than a robot there can map. The lobbies at N
///       W ---- C ---- E         and S and the alcove at SW end where a robot at the place sees
///       |      |      |         it, so they are no gateways.
///       SW --- S --- SE
///
/// Furniture, doors and rooms are drawn.
Building ring_building(RandomEngine& engine);

/// The way that was driven there: N NE E SE S SW W NW N C S C W C E.
Route ring_route(const World& ring);

}  // namespace asterism
