#pragma once

#include <map>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/formula_reader.hpp"
#include "axioms/sexpr.hpp"

namespace asterism {

/// Turns SMT-LIB 2 files into an axiom set. Declarations may stand in any file, in any order.
///
///     (declare-sort S 0) (declare-const c S) (declare-fun f (S ...) S)
///     (assert (! (forall ((x S) ...) (=> PREMISE CONCLUSION)) :named axiom.name))
///     (set-info :extent (NAME ((x DState) ...) :where PREMISE TERM ...))
///     (set-info :minimise (path place))
///
/// PREMISE: a conjunction of atoms, equalities and their negations. CONCLUSION: any of and, or,
/// not, =, atoms, true, false. Names are of letters, digits and _. The comment above an assertion
/// or an extent gives name and source in its first line, then words, then, indented, the formula.
///
/// For one thread at a time.
class AxiomReader {
 public:
  AxiomReader() = default;
  AxiomReader(const AxiomReader&) = delete;

  /// Reads files that are one set together.
  /// @param where  what the files are together, for messages
  /// @throws InputError with file and line, or `where` if a declaration that facts need is missing
  AxiomSet read(const std::map<std::string, std::string>& files, const std::string& where);

 private:
  static const std::vector<ExtentDeclaration>& shipped_extents();

  void read_forms(const std::map<std::string, std::string>& files, const std::string& where);
  void declare(const SExpr& form);
  void declare_function(const SExpr& name, const SExpr& arguments, const SExpr& result);
  void say(const SExpr& form);
  void add(Axiom axiom, const SExpr& form);
  Axiom assertion(const SExpr& form) const;
  void document(Axiom& axiom, const SExpr& form) const;
  void require_safe(const Axiom& axiom, const SExpr& form) const;
  void add_extent(const SExpr& form);
  void set_preference(const SExpr& form);
  void settle(const std::vector<ExtentDeclaration>& shipped);

  AxiomSet::Contents contents_;
  std::vector<std::string> minimised_;  ///< names
  FormulaReader words_{contents_.sorts, contents_.functions};
};

}  // namespace asterism
