#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "axioms/axiom_solver.hpp"
#include "core/error.hpp"
#include "engine/ssh_closure.hpp"
#include "engine/ssh_table.hpp"

namespace asterism {

/// Native engine and solver disagree on an experience: a fault in one of them.
class SshDifferenceError : public Error {
 public:
  SshDifferenceError(const std::string& what, Experience shortest)
      : Error(what), shortest_experience(std::move(shortest)) {}
  Experience shortest_experience;  ///< the shortest beginning that shows it
};

// Who decides at which dstate a view may have been seen. Each follows one hypothesis, view by view:
// try_enter(d) says whether view k may have been seen at dstate d, and if so goes on from there;
// leave() goes back. The number after that of the last dstate is a new dstate.

/// Decides by SshClosure.
class SshNative {
 public:
  using DState = SshTable::DState;

  SshNative(const SshTable& table, SshClosure::OptionalAxioms optional)
      : table_(table), empty_(table.views(), optional), levels_(table.views(), empty_) {}

  void reset();
  /// Dstates at which the next view may have been seen, as far as views and known results tell.
  std::vector<DState> candidates() const;
  bool try_enter(DState dstate);
  void leave();
  std::uint64_t undecided() const { return 0; }

 private:
  const SshTable& table_;
  SshClosure empty_;
  std::vector<SshClosure> levels_;  ///< after each view; those not reached are scratch
  std::vector<DState> named_;
  std::vector<std::uint32_t> views_;  ///< of each dstate
};

/// Z3 over the axiom files alone decides every candidate: each dstate, and a new one.  [DESIGN §8]
class SshSolver {
 public:
  using DState = SshTable::DState;

  SshSolver(const SshTable& table, const AxiomSet& axioms, unsigned timeout_ms)
      : table_(table), axioms_(axioms), timeout_ms_(timeout_ms), solver_(axioms, timeout_ms) {}

  void reset();
  std::vector<DState> candidates() const;
  Verdict enter(DState dstate);
  bool try_enter(DState dstate);
  void leave();
  std::uint64_t undecided() const { return undecided_; }
  std::span<const DState> named() const { return named_; }

 private:
  const SshTable& table_;
  const AxiomSet& axioms_;
  unsigned timeout_ms_;
  AxiomSolver solver_;
  std::vector<DState> named_;
  std::uint64_t undecided_ = 0;
};

/// Both, compared at every candidate.
class SshBoth {
 public:
  using DState = SshTable::DState;

  SshBoth(SshNative native, SshSolver solver, const SshTable& table)
      : native_(std::move(native)), solver_(std::move(solver)), table_(table) {}

  void reset();
  std::vector<DState> candidates() const { return solver_.candidates(); }
  /// @throws SshDifferenceError
  bool try_enter(DState dstate);
  void leave();
  std::uint64_t undecided() const { return solver_.undecided(); }

 private:
  SshNative native_;
  SshSolver solver_;
  const SshTable& table_;
};

}  // namespace asterism
