#pragma once

#include "core/map_report.hpp"
#include "io/json/json_node.hpp"

namespace asterism {

/// Refuses a report whose counts, maps and ranked maps, each read already, do not agree.
/// @param root  where the report was read from
/// @throws InputError
void require_agreement(const JsonNode& root, const MapReport& report);

/// Refuses a report of the basic SSH likewise.  @throws InputError
void require_agreement(const JsonNode& root, const SshReport& report);

}  // namespace asterism
