#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/extents.hpp"

namespace asterism {

/// A term of an axiom: a variable, a constant, or a function of one term.
struct Term {
  enum class Kind { variable, constant, application };
  Kind kind = Kind::constant;
  std::size_t variable = 0;    ///< position among the axiom's variables
  std::string symbol;          ///< of a constant or function
  std::vector<Term> argument;  ///< one, of an application

  friend bool operator==(const Term&, const Term&) = default;
};

/// A formula of an axiom, without quantifiers.
struct Formula {
  enum class Kind { truth, falsity, relation, equality, negation, conjunction, disjunction };
  Kind kind = Kind::truth;
  std::string relation;
  std::vector<Term> terms;     ///< of a relation, or the two sides of an equality
  std::vector<Formula> parts;  ///< of a negation (one), conjunction or disjunction

  friend bool operator==(const Formula&, const Formula&) = default;
};

/// ∀ variables. premise → conclusion, every variable standing by itself in a relation of the
/// premise that is not negated.
struct Axiom {
  /// A variable bound by the axiom's quantifier.
  struct Variable {
    std::string name;
    std::string sort;
    friend bool operator==(const Variable&, const Variable&) = default;
  };

  std::string name;
  std::string source;   ///< "[BMK10, (8)] [RK04]"
  std::string words;    ///< one sentence
  std::string formula;  ///< as written in the comment, for people
  std::string file;
  std::size_t line = 0;
  bool by_signature = false;  ///< said by a declaration, not by an assertion
  std::string function;       ///< that declaration's, where it is one

  std::vector<Variable> variables;
  std::vector<Formula> premise;  ///< all of these
  Formula conclusion;
};

/// Whether two axioms have one name and say the same, whatever their comments and the names of
/// variables.
bool same_statement(const Axiom& a, const Axiom& b);
/// Whether variables are as many and of the same sorts, in order.
bool same_sorts(std::span<const Axiom::Variable> a, std::span<const Axiom::Variable> b);

/// An extent: the number of classes of the values of its terms, its variables standing for every
/// dstate for which the premise holds. The terms of one instance are in one class. What holds and
/// what is equal is the least that the axioms force.                          [theory §5, §6]
struct ExtentDeclaration {
  std::string name;
  std::string source;
  std::string words;
  std::string formula;
  std::string file;
  std::size_t line = 0;

  std::vector<Axiom::Variable> variables;  ///< all of sort DState
  std::vector<Formula> premise;            ///< all of these
  std::vector<Term> terms;                 ///< of one sort; at least one
  std::optional<Extent> known;             ///< if it counts as the shipped one of its name
};

/// Axioms and preference, as read from files.                               [theory §5, §6]
///
/// Copies share what was read, which nothing changes: every tree and every search holds one.
/// So threads may each use a copy.
class AxiomSet {
 public:
  AxiomSet(const AxiomSet&) = default;  // no moves, which would leave nothing behind
  AxiomSet& operator=(const AxiomSet&) = default;

  /// What a declaration says of a function or relation.
  struct Function {
    std::vector<std::string> arguments;  ///< sorts
    std::string result;                  ///< sort; "Bool" for a relation
    friend bool operator==(const Function&, const Function&) = default;
  };

  /// The axioms built in, with the named optional ones switched on.
  /// @throws InputError if there is no optional axiom of that name
  static AxiomSet shipped(std::span<const std::string> optional = {});
  /// All *.smt2 files of a folder, with the named ones of its folder `optional`, or of the built-in
  /// ones where it has none.
  /// @throws InputError with file and line
  static AxiomSet read(const std::string& folder, std::span<const std::string> optional = {});
  /// The axioms of texts, given by file name.
  /// @param where  what they are together, for messages
  /// @throws InputError with file and line, or `where`
  static AxiomSet parse(const std::map<std::string, std::string>& files,
                        const std::string& where = "axioms");

  /// Names of the optional axioms built in.
  static std::vector<std::string> optional_names();
  /// The files built in, by name ("causal.smt2", "optional/one_segment.smt2").
  static const std::map<std::string, std::string>& built_in_files();

  /// All axioms in the order of files and lines; those said by the signature among them.
  const std::vector<Axiom>& axioms() const { return contents_->axioms; }
  /// Names of the sorts declared.
  const std::vector<std::string>& sorts() const { return contents_->sorts; }
  /// Functions, relations and constants declared, by name.
  const std::map<std::string, Function>& functions() const { return contents_->functions; }
  /// Extents that are declared, in the order of files and lines; then path, place and segment as
  /// shipped, where no other is called so.
  const std::vector<ExtentDeclaration>& extents() const { return contents_->extents; }
  /// Extents to minimise, the first before the second.                          [theory §6]
  const std::vector<ExtentDeclaration>& minimised() const { return contents_->minimised; }
  /// Names of the extents to minimise, in order. One that is called as a shipped one and is another
  /// says so: "path (own)".
  std::vector<std::string> preference_names() const;

  /// Whether an extent to minimise is none of the shipped ones.
  bool minimises_own() const { return !contents_->preference.has_value(); }
  /// Extents to minimise, as the program knows them.
  /// @throws std::logic_error if minimises_own()
  const std::vector<Extent>& preference() const;
  /// What a shipped extent counts, as far as these axioms have its words, whatever they call so.
  const ExtentDeclaration& shipped_extent(Extent extent) const {
    return contents_->shipped_extents[static_cast<std::size_t>(extent)];
  }

  /// Whether there is an axiom of that name.
  bool contains(std::string_view axiom) const;
  /// Whether dstates, actions, views, which are named apart, are what this sort holds: no function
  /// makes them.
  bool has_unique_names(const std::string& sort) const;
  /// Whether these are the shipped axioms and optional ones, whatever the order, the comments and
  /// the names of variables, and the shipped extents are minimised, whichever and in whatever
  /// order: the native engine knows those and no others.
  bool is_shipped() const;

 private:
  struct Contents {
    std::vector<Axiom> axioms;
    std::vector<std::string> sorts;
    std::map<std::string, Function> functions;
    std::vector<ExtentDeclaration> extents;
    std::vector<ExtentDeclaration> minimised;
    std::optional<std::vector<Extent>> preference;   ///< absent: the files' own
    std::vector<ExtentDeclaration> shipped_extents;  ///< by Extent
  };
  explicit AxiomSet(std::shared_ptr<const Contents> contents) : contents_(std::move(contents)) {}

  std::shared_ptr<const Contents> contents_;

  friend class AxiomReader;
};

}  // namespace asterism
