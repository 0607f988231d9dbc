#include "mapping/checkpointing.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "core/error.hpp"

namespace asterism {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::invalid_argument& error) {
  throw InputError(file, std::string("a state where ") + error.what(),
                   "one of the search to go on with");
}

}  // namespace

bool Checkpointing::resume(MinimalSearch& search, const Stop& stop) {
  std::error_code ignored;  // what cannot be asked for cannot be read either
  if (!std::filesystem::exists(std::filesystem::status(options_.file, ignored))) return false;
  // As text, as read, and twice as arms.
  constexpr std::uint64_t times_its_size = 6;
  const std::uint64_t size = std::filesystem::file_size(options_.file, ignored);
  if (!stop.has_room_for(times_its_size * size))
    throw InputError(options_.file, fmt::format("{} bytes", size),
                     "a memory limit with room for six times as many");
  const Checkpoint checkpoint = read_checkpoint_file(options_.file);
  require_same_search(checkpoint, search_, options_.file);
  try {
    search.resume(checkpoint.state);
  } catch (const std::invalid_argument& error) {
    refuse(options_.file, error);
  }
  return is_resumed_ = true;
}

MinimalSearch::Outcome Checkpointing::run(MinimalSearch& search, const Stop& stop) {
  write(search);
  Stop writing = stop;
  writing.watch = [&](const Standing& standing) -> std::optional<std::string> {
    if (auto why = stop.watch ? stop.watch(standing) : std::nullopt) return why;
    // What is written is a copy of all that is held.
    if (!stop.has_room_for(search.memory_bytes())) return "memory limit";
    if (std::chrono::steady_clock::now() - written_ >= options_.every) try_to_write(search);
    return std::nullopt;
  };
  try {
    const auto outcome = search.run(writing);
    stop.reason = writing.reason;
    if (outcome == MinimalSearch::Outcome::stopped) try_to_write(search);
    return outcome;
  } catch (const std::invalid_argument& error) {
    if (!is_resumed_) throw;
    refuse(options_.file, error);
  }
}

void Checkpointing::write(const MinimalSearch& search) {
  write_checkpoint_file(options_.file, {search_, search.state()});
  written_ = std::chrono::steady_clock::now();
}

void Checkpointing::try_to_write(const MinimalSearch& search) {
  try {
    write(search);
  } catch (const Error& error) {
    options_.failed(error.what());
    written_ = std::chrono::steady_clock::now();
  }
}

void Checkpointing::remove() const {
  std::error_code ignored;  // it may not have come to one
  std::filesystem::remove(options_.file, ignored);
}

}  // namespace asterism
