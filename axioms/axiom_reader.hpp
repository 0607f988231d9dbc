#pragma once

#include <map>
#include <string>

#include "axioms/axiom_set.hpp"
#include "axioms/sexpr.hpp"

namespace asterism {

/// Turns SMT-LIB 2 files into an axiom set. Declarations may stand in any file, in any order.
///
///     (declare-sort S 0) (declare-const c S) (declare-fun f (S ...) S)
///     (assert (! (forall ((x S) ...) (=> PREMISE CONCLUSION)) :named axiom.name))
///     (set-info :minimise (path place))
///
/// PREMISE: a conjunction of atoms, equalities and their negations. CONCLUSION: any of and, or,
/// not,
/// =, atoms, true, false. Names are of letters, digits and _. The comment above an assertion gives
/// name and source in its first line, then words, then, indented, the formula.
class AxiomReader {
 public:
  /// @param where  what the files are together, for messages
  /// @throws InputError with file and line, or `where` if a declaration that facts need is missing
  AxiomSet read(const std::map<std::string, std::string>& files, const std::string& where);

 private:
  [[noreturn]] void fail(const SExpr& at, const std::string& expected) const;

  void declare(const SExpr& form);
  void declare_function(const SExpr& name, const SExpr& arguments, const SExpr& result);
  void require_sort(const SExpr& sort) const;
  void require_name(const SExpr& name) const;
  void add(Axiom axiom, const SExpr& form);
  void set_preference(const SExpr& form);
  Axiom assertion(const SExpr& form) const;
  void document(Axiom& axiom, const SExpr& form) const;
  void require_safe(const Axiom& axiom, const SExpr& form) const;
  Formula formula(const SExpr& form, const Axiom& axiom) const;
  Term term(const SExpr& form, const Axiom& axiom) const;
  std::string sort_of(const Term& term, const Axiom& axiom) const;

  AxiomSet::Contents contents_;
  std::string file_;  ///< being read
};

}  // namespace asterism
