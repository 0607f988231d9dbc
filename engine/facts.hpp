#pragma once

#include <span>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/fact.hpp"
#include "engine/arm_table.hpp"

namespace asterism {

/// What hypotheses say to the axioms, as ground atoms. The constant d3_1 is the dstate at the place
/// first seen at visit 3, facing along its arm 1; v2 is the view numbered 2.

std::string dstate_name(const ArmTable& table, ArmId arm);

/// Which actions are turns: holds whatever the trace.
std::vector<Fact> general_facts();

/// The star of the place first seen at visit k: next, opposite, ends, and what is seen along each
/// arm.
std::vector<Fact> place_facts(const ArmTable& table, VisitId k);

/// The robot travelled from arm `left` and came in by `entered`, an arm of whatever place it is:
/// where that led to, and what was seen there.
std::vector<Fact> travel_facts(const ArmTable& table, VisitId k, ArmId left, ArmId entered);

/// All that visit k adds to a hypothesis: the place's star if it is new, the travel to it.
/// @param named  arms entered by at the visits up to k
std::vector<Fact> visit_facts(const ArmTable& table, std::span<const ArmId> named);

/// All that a hypothesis says.
std::vector<Fact> map_facts(const ArmTable& table, std::span<const ArmId> named);

/// The grounded problem of a hypothesis as SMT-LIB 2 text: sat iff it is consistent.
std::string smt2_text(const Trace& trace, std::span<const Arrival> hypothesis,
                      const AxiomSet& axioms);

}  // namespace asterism
