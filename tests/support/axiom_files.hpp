#pragma once

#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "axioms/axiom_set.hpp"

namespace asterism {

using AxiomFiles = std::map<std::string, std::string>;

/// The shipped files, without the optional ones.
inline AxiomFiles shipped_files() {
  AxiomFiles files;
  for (const auto& [name, text] : AxiomSet::built_in_files())
    if (!name.starts_with("optional/")) files[name] = text;
  return files;
}

/// The files with the assertion of this name replaced by other text, or left out.
inline AxiomFiles with_axiom(AxiomFiles files, const std::string& name,
                             const std::string& replacement = "") {
  for (auto& [file, text] : files) {
    const std::string label = ":named axiom." + name + "))";
    const std::size_t mark = text.find(label);
    if (mark == std::string::npos) continue;
    const std::size_t begin = text.rfind("(assert", mark);
    const std::size_t end = mark + label.size();
    text.replace(begin, end - begin, replacement);
    return files;
  }
  throw std::logic_error("no axiom " + name);
}

/// The shipped axioms of these names, and no others; those of the signature stay.
inline const AxiomSet& only(const std::set<std::string>& names) {
  static std::map<std::set<std::string>, AxiomSet> known;
  if (const auto set = known.find(names); set != known.end()) return set->second;
  AxiomFiles files = shipped_files();
  const AxiomSet shipped = AxiomSet::parse(files);
  for (const Axiom& axiom : shipped.axioms())
    if (!axiom.by_signature && !names.contains(axiom.name)) files = with_axiom(files, axiom.name);
  return known.emplace(names, AxiomSet::parse(files)).first->second;
}

}  // namespace asterism
