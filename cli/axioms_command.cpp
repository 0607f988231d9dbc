#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/options.hpp"

namespace asterism {

int axioms_command(const AxiomOptions& options) {
  const AxiomSet axioms = options.read();
  for (const Axiom& axiom : axioms.axioms()) {
    fmt::print("{:<14} {}\n", axiom.name, axiom.source);
    if (!axiom.words.empty()) fmt::print("    {}\n", axiom.words);
    if (!axiom.formula.empty()) fmt::print("    {}\n", axiom.formula);
    fmt::print("    {}:{}{}\n\n", axiom.file, axiom.line,
               axiom.by_signature ? ", by signature" : "");
  }
  fmt::print("minimised, the first before the next: {}\n", fmt::join(axioms.preference(), ", "));
  fmt::print("optional axioms, on with --axiom NAME: {}\n",
             fmt::join(AxiomSet::optional_names(), ", "));
  return exit_consistent;
}

}  // namespace asterism
