#pragma once

#include <z3++.h>

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "axioms/grounder.hpp"

namespace asterism {

/// Ground atoms and instances of a grounder, written for Z3.
class Z3GroundTerms {
 public:
  /// @param context, grounder  outlive this
  Z3GroundTerms(z3::context& context, Grounder& grounder);

  /// A relation of constants and functions.
  z3::expr atom(const Grounder::GroundAtom& atom);
  /// premise → conclusion; equalities between constants named apart are decided.
  z3::expr instance(const Grounder::Instance& instance);

 private:
  z3::expr term(Grounder::TermId id);
  z3::expr equality(Grounder::TermId a, Grounder::TermId b);
  z3::expr written(const Grounder::Instance& instance);

  z3::context& context_;
  Grounder& grounder_;
  std::map<std::string, z3::func_decl> functions_;
  std::vector<z3::func_decl> relations_;
  std::vector<z3::expr> terms_;
  struct KeyHash {
    std::size_t operator()(const std::vector<Grounder::TermId>& key) const;
  };
  std::map<const Axiom*, std::unordered_map<std::vector<Grounder::TermId>, z3::expr, KeyHash>>
      instances_;
};

}  // namespace asterism
