#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "cli/asked_maps.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"

namespace asterism {
namespace {

int run(const AxiomSource& source) {
  const AxiomSet axioms = read_axioms(source);
  for (const Axiom& axiom : axioms.axioms()) {
    fmt::print("{:<14} {}\n", axiom.name, axiom.source);
    if (!axiom.words.empty()) fmt::print("    {}\n", axiom.words);
    if (!axiom.formula.empty()) fmt::print("    {}\n", axiom.formula);
    fmt::print("    {}:{}{}\n\n", axiom.file, axiom.line,
               axiom.by_signature ? ", by signature" : "");
  }
  for (const ExtentDeclaration& extent : axioms.extents()) {
    fmt::print("extent {:<7} {}\n", extent.name, extent.source);
    if (!extent.words.empty()) fmt::print("    {}\n", extent.words);
    if (!extent.formula.empty()) fmt::print("    {}\n", extent.formula);
    fmt::print("    {}:{}\n\n", extent.file, extent.line);
  }
  fmt::print("minimised, the first before the next: {}\n",
             fmt::join(axioms.preference_names(), ", "));
  fmt::print("optional axioms, on with --axiom NAME: {}\n",
             fmt::join(AxiomSet::optional_names(), ", "));
  return exit_consistent;
}

void add_options(CLI::App& axioms, AxiomSource& asked) { add_axiom_options(axioms, asked); }

}  // namespace

void add_axioms(CLI::App& app, Run& chosen) {
  add_command(app, chosen, "axioms", "Print the axioms in force", add_options, run, R"(Examples:
  asterism axioms
  asterism axioms --axiom one_crossing
  asterism axioms --axioms my-axioms)");
}

}  // namespace asterism
