#pragma once

#include <variant>

#include "core/experience.hpp"
#include "core/map_report.hpp"
#include "core/trace.hpp"

namespace asterism {

/// Whether two hold the same, member by member.
bool same(const Trace& a, const Trace& b);
bool same(const MapReport& a, const MapReport& b);
bool same(const SshReport& a, const SshReport& b);
inline bool same(const Experience& a, const Experience& b) { return a == b; }

/// Whether one of either kind is this one.
template <class Kind, class... Kinds>
bool same(const std::variant<Kinds...>& any, const Kind& one) {
  const Kind* const of_this_kind = std::get_if<Kind>(&any);
  return of_this_kind != nullptr && same(*of_this_kind, one);
}

}  // namespace asterism
