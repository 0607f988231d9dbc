#include "mapping/own_process.hpp"

#include <csignal>
#include <new>
#include <stdexcept>

#include "core/error.hpp"
#include "tests/support/catch.hpp"

using namespace asterism;

TEST_CASE("what a process of its own finds is told, however long", "[mapping][unit]") {
  CHECK(in_own_process([] { return "found"; }, Deadline::max()) == "found");
  CHECK(in_own_process([] { return ""; }, Deadline::max()) == "");
  const std::string much(1'000'000, 'x');
  CHECK(in_own_process([&] { return much; }, deadline_in(100)) == much);
}

TEST_CASE("what a process of its own changes stays with it", "[mapping][unit]") {
  int here = 1;
  CHECK(in_own_process([&] { return std::to_string(++here); }, Deadline::max()) == "2");
  CHECK(here == 1);
}

TEST_CASE("a process of its own is killed at its deadline", "[mapping][unit]") {
  const auto never_ends = [] {
    for (volatile bool on = true; on;) {
    }
    return "";
  };
  CHECK(in_own_process(never_ends, deadline_in(0.1)) == std::nullopt);
}

TEST_CASE("a process of its own that dies, or has no memory, has found nothing",
          "[mapping][unit]") {
  const auto is_killed = []() -> std::string {
    std::raise(SIGKILL);
    return "alive";
  };
  const auto has_no_memory = []() -> std::string { throw std::bad_alloc(); };
  const auto solver_has_none = []() -> std::string {
    throw SolverMemoryError("z3: out of memory");
  };
  CHECK(in_own_process(is_killed, Deadline::max()) == std::nullopt);
  CHECK(in_own_process(has_no_memory, Deadline::max()) == std::nullopt);
  CHECK(in_own_process(solver_has_none, Deadline::max()) == std::nullopt);
}

TEST_CASE("what a process of its own throws is thrown here", "[mapping][unit]") {
  const auto fails = []() -> std::string { throw std::logic_error("a fault"); };
  CHECK_THROWS_WITH(in_own_process(fails, Deadline::max()), "a fault");
}
