#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/stop.hpp"

namespace asterism {

/// Has a text worked out in a process of its own, a copy of this one, which is killed at the
/// deadline: for what does not look at the clock, as solvers do not always, or needs memory that
/// must not be missing here. It ends with this process. Other threads of this one are not in it.
/// @return  nothing if it was killed, or died of what it did, as where memory was short
/// @throws  Error with the message of what it threw but for want of memory, or if no process can
///          be started
std::optional<std::string> in_own_process(const std::function<std::string()>& work,
                                          Deadline deadline);

}  // namespace asterism
