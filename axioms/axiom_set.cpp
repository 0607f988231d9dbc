#include "axioms/axiom_set.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "axioms/axiom_reader.hpp"
#include "core/error.hpp"

namespace asterism {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream) throw InputError(file.string(), "an unreadable file", "axioms in SMT-LIB 2");
  return text;
}

std::string optional_file(const std::string& name) { return "optional/" + name + ".smt2"; }

void add_optional(std::map<std::string, std::string>& files, std::span<const std::string> names,
                  const std::string& folder) {
  for (const std::string& name : names) {
    const fs::path own = fs::path(folder) / optional_file(name);
    const auto built_in = AxiomSet::built_in_files().find(optional_file(name));
    const bool is_word = std::all_of(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
    if (is_word && !folder.empty() && fs::is_regular_file(own)) {
      files[own.string()] = contents(own);
    } else if (built_in != AxiomSet::built_in_files().end()) {
      files[built_in->first] = built_in->second;
    } else {
      std::string known;
      for (const std::string& other : AxiomSet::optional_names())
        known += (known.empty() ? "" : ", ") + other;
      throw InputError("optional axiom", "\"" + name + "\"", "one of " + known);
    }
  }
}

/// Those not said by the signature: which of those there are is up to comments.
std::vector<Axiom> assertions(const AxiomSet& axioms) {
  std::vector<Axiom> result;
  for (const Axiom& axiom : axioms.axioms())
    if (!axiom.by_signature) result.push_back(axiom);
  return result;
}

}  // namespace

bool same_statement(const Axiom& a, const Axiom& b) {
  return a.name == b.name && same_sorts(a.variables, b.variables) && a.premise == b.premise &&
         a.conclusion == b.conclusion && a.function == b.function;
}

bool same_sorts(std::span<const Axiom::Variable> a, std::span<const Axiom::Variable> b) {
  return std::ranges::equal(a, b, {}, &Axiom::Variable::sort, &Axiom::Variable::sort);
}

AxiomSet AxiomSet::parse(const std::map<std::string, std::string>& files,
                         const std::string& where) {
  return AxiomReader().read(files, where);
}

AxiomSet AxiomSet::shipped(std::span<const std::string> optional) {
  std::map<std::string, std::string> files;
  for (const auto& [name, text] : built_in_files())
    if (!name.starts_with("optional/")) files[name] = text;
  if (optional.empty()) {
    static const AxiomSet plain = parse(files);  // every tree asks for it
    return plain;
  }
  add_optional(files, optional, "");
  return parse(files);
}

AxiomSet AxiomSet::read(const std::string& folder, std::span<const std::string> optional) {
  std::error_code error;
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".smt2" && entry.is_regular_file())
      files[entry.path().string()] = contents(entry.path());
  if (error) throw InputError(folder, error.message(), "a folder of axiom files");
  if (files.empty()) throw InputError(folder, "no *.smt2", "a folder of axiom files");
  add_optional(files, optional, folder);
  return parse(files, folder);
}

std::vector<std::string> AxiomSet::optional_names() {
  std::vector<std::string> result;
  for (const auto& [name, text] : built_in_files())
    if (name.starts_with("optional/")) result.push_back(fs::path(name).stem().string());
  return result;
}

std::vector<std::string> AxiomSet::preference_names() const {
  std::vector<std::string> names;
  for (const ExtentDeclaration& extent : minimised())
    names.push_back(extent.name + (extent_named(extent.name) && !extent.known ? " (own)" : ""));
  return names;
}

const std::vector<Extent>& AxiomSet::preference() const {
  if (minimises_own()) throw std::logic_error("an extent that the program does not know");
  return *contents_->preference;
}

bool AxiomSet::contains(std::string_view axiom) const {
  return std::ranges::find(axioms(), axiom, &Axiom::name) != axioms().end();
}

bool AxiomSet::has_unique_names(const std::string& sort) const {
  return std::ranges::none_of(functions(), [&](const auto& entry) {
    return entry.second.result == sort && !entry.second.arguments.empty();
  });
}

bool AxiomSet::is_shipped() const {
  if (minimises_own()) return false;
  std::vector<std::string> optional;
  for (const std::string& name : optional_names())
    if (contains(name)) optional.push_back(name);
  const AxiomSet ours = shipped(optional);
  if (contents_ == ours.contents_) return true;
  const std::vector<Axiom> here = assertions(*this);
  const std::vector<Axiom> there = assertions(ours);
  if (functions() != ours.functions() || here.size() != there.size()) return false;
  return std::all_of(here.begin(), here.end(), [&](const Axiom& axiom) {
    return std::any_of(there.begin(), there.end(),
                       [&](const Axiom& other) { return same_statement(axiom, other); });
  });
}

}  // namespace asterism
