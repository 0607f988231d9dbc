#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "axioms/sexpr.hpp"

namespace asterism {

/// What a comment says of the form below it.
///
///     ; name                  [source]
///     ; Words.
///     ;   formula
struct Documentation {
  std::string source;
  std::string words;
  std::string formula;
};

/// The name in the first line of a comment, where a source follows it.
std::optional<std::string> documented_name(const std::string& comment);

/// Reads what axioms and extents are made of: names, variables, terms and formulas over the sorts
/// and functions declared. What it cannot read it refuses with an InputError of file and line.
/// For one thread at a time.
class FormulaReader {
 public:
  using Variables = std::vector<Axiom::Variable>;

  /// @param sorts, functions  must outlive it; they may grow
  FormulaReader(const std::vector<std::string>& sorts,
                const std::map<std::string, AxiomSet::Function>& functions)
      : sorts_(sorts), functions_(functions) {}

  /// @param name  of the file that is read from now on, for messages
  void set_file(std::string name) { file_ = std::move(name); }
  const std::string& file() const { return file_; }
  [[noreturn]] void fail(const SExpr& at, const std::string& expected) const;

  void require_name(const SExpr& name) const;
  void require_sort(const SExpr& sort) const;
  Variables variables(const SExpr& list) const;
  /// The parts of a conjunction, or one formula alone.
  std::vector<Formula> premise(const SExpr& form, const Variables& variables) const;
  /// A premise has atoms, equalities and their negations alone.
  /// @param within  the form to name where it does not
  void require_literals(const std::vector<Formula>& premise, const SExpr& within) const;
  Formula formula(const SExpr& form, const Variables& variables) const;
  Term term(const SExpr& form, const Variables& variables) const;
  std::string sort_of(const Term& term, const Variables& variables) const;
  /// Of the form that is called `name`; nothing where its comment gives no source.
  Documentation documentation(const SExpr& form, const std::string& name) const;

 private:
  const std::vector<std::string>& sorts_;
  const std::map<std::string, AxiomSet::Function>& functions_;
  std::string file_;
};

}  // namespace asterism
