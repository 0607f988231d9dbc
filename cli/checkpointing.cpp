#include "cli/checkpointing.hpp"

#include <fmt/format.h>

#include <cstdio>
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

Checkpointing::Checkpointing(const MapCommand& command, const AxiomSet& axioms, const Trace& trace)
    : file_(command.checkpoint.value()),
      every_(command.checkpoint_every_s),
      search_{.trace = trace.name,
              .digest = digest(trace),
              .planar = command.options.planar,
              .optional_axioms = command.options.optional_axioms,
              .preference = axioms.preference(),
              .assumptions = command.options.assumptions} {
  std::error_code ignored;  // what cannot be asked for cannot be written either
  const auto status = std::filesystem::status(file_, ignored);
  if (command.json == file_)
    throw InputError("--checkpoint", "the file of --json", "a file of its own");
  if (std::filesystem::exists(status) && !command.resume)
    throw InputError(file_, "a file that is there already", "none, or --resume to go on from it");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw InputError(file_, "what is no regular file", "a checkpoint");
}

void Checkpointing::resume(MinimalSearch& search, const Progress& progress) {
  std::error_code ignored;  // what cannot be asked for cannot be read either
  if (!std::filesystem::exists(std::filesystem::status(file_, ignored))) {
    fmt::print(stderr, "{}: no checkpoint to resume from; the search begins afresh\n", file_);
    return;
  }
  // As text, as read, and twice as arms.
  constexpr std::uint64_t times_its_size = 6;
  const std::uint64_t size = std::filesystem::file_size(file_, ignored);
  if (!progress.has_room(times_its_size * size))
    throw InputError(file_, fmt::format("{} bytes", size),
                     "a memory limit with room for six times as many");
  const Checkpoint checkpoint = read_checkpoint_file(file_);
  require_same_search(checkpoint, search_, file_);
  try {
    search.resume(checkpoint.state);
  } catch (const std::invalid_argument& error) {
    refuse(file_, error);
  }
  is_resumed_ = true;
}

MinimalSearch::Outcome Checkpointing::run(MinimalSearch& search,
                                          const std::function<bool(const MinimalSearch&)>& go_on) {
  write(search);
  try {
    const auto outcome = search.run([&](const MinimalSearch& running) {
      if (!go_on(running)) return false;
      if (std::chrono::steady_clock::now() - written_ >= every_) try_to_write(running);
      return true;
    });
    if (outcome == MinimalSearch::Outcome::stopped) try_to_write(search);
    return outcome;
  } catch (const std::invalid_argument& error) {
    if (!is_resumed_) throw;
    refuse(file_, error);
  }
}

void Checkpointing::write(const MinimalSearch& search) {
  write_checkpoint_file(file_, {search_, search.state()});
  written_ = std::chrono::steady_clock::now();
}

void Checkpointing::try_to_write(const MinimalSearch& search) {
  try {
    write(search);
  } catch (const Error& error) {
    fmt::print(stderr, "{}; the checkpoint written before stays\n", error.what());
    written_ = std::chrono::steady_clock::now();
  }
}

void Checkpointing::remove() const {
  std::error_code ignored;  // it may not have come to one
  std::filesystem::remove(file_, ignored);
}

}  // namespace asterism
