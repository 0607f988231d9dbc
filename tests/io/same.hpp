#pragma once

#include "core/map_report.hpp"
#include "core/trace.hpp"

namespace asterism {

/// Whether two hold the same, member by member.
bool same(const Trace& a, const Trace& b);
bool same(const MapReport& a, const MapReport& b);

}  // namespace asterism
