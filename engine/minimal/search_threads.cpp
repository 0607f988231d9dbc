#include "engine/minimal/search_threads.hpp"

#include <algorithm>
#include <exception>
#include <thread>

#include "core/stop.hpp"

namespace asterism {
namespace {

/// Before a second worker is worth its start.
constexpr std::uint64_t steps_alone = 500;
constexpr std::uint64_t steps_a_turn = 512;

}  // namespace

bool SearchThreads::work(const Folding& begun, unsigned jobs) {
  const bool alone = workers_.size() <= 1 && branchings() < steps_alone;
  const std::size_t threads = alone ? 1 : jobs;
  const std::size_t ends = alone ? 1 : 2;
  make(threads * ends, begun);
  level_.start(static_cast<unsigned>(threads), deadline_in(slice_s));
  std::vector<std::exception_ptr> failures(threads);
  const auto work_as = [&](std::size_t thread) {
    try {
      take_turns(std::span(workers_).subspan(thread * ends, ends),
                 alone ? steps_alone : UINT64_MAX);
    } catch (...) {
      failures[thread] = std::current_exception();
      level_.stop();
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t thread = 1; thread < threads; ++thread) others.emplace_back(work_as, thread);
    } catch (...) {  // no more threads to be had
      level_.stop();
      throw;
    }
    work_as(0);
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return level_.branches.empty() &&
         std::ranges::all_of(workers_, [](const SearchWorker& worker) { return worker.is_idle(); });
}

void SearchThreads::take_turns(std::span<SearchWorker> ends, std::uint64_t most_steps) {
  for (std::uint64_t step = 0; !level_.is_stopped(); ++step) {
    const std::size_t turn = step / steps_a_turn % ends.size();
    SearchWorker* worker = &ends[turn];
    SearchWorker& other = ends[ends.size() - 1 - turn];
    if (worker->is_idle()) {
      const bool both_are = other.is_idle();
      const auto branch = both_are ? level_.take() : other.give();
      if (branch)
        worker->take(*branch);
      else if (both_are)
        return;
      else
        worker = &other;
    }
    if (!worker->is_idle()) worker->advance();
    if (level_.is_hungry())
      if (auto branch = worker->give()) level_.give(std::move(*branch));
    if ((step % 4 == 0 && level_.is_due()) || step >= most_steps) return level_.stop();
  }
}

bool SearchThreads::hold(const std::deque<SearchState::Branch>& branches, const Folding& begun) {
  SearchWorker worker(table_, preference_, begun, level_);
  return std::ranges::all_of(
      branches, [&](const SearchState::Branch& branch) { return worker.take(branch); });
}

void SearchThreads::make(std::size_t count, const Folding& begun) {
  while (workers_.size() < count) workers_.emplace_back(table_, preference_, begun, level_);
}

void SearchThreads::forget() {
  branchings_before_ = branchings();
  workers_.clear();
}

void SearchThreads::add_branches(std::vector<SearchState::Branch>& branches) const {
  for (const SearchWorker& worker : workers_) worker.add_branches(branches);
}

std::uint64_t SearchThreads::branchings() const {
  std::uint64_t sum = branchings_before_;
  for (const SearchWorker& worker : workers_) sum += worker.branchings();
  return sum;
}

std::size_t SearchThreads::memory_bytes() const {
  std::size_t bytes = 0;
  for (const SearchWorker& worker : workers_) bytes += worker.memory_bytes();
  return bytes;
}

}  // namespace asterism
