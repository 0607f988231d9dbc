#include "axioms/vocabulary.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace asterism {
namespace {

using Function = AxiomSet::Function;

const std::set<std::string> words_of_smt_lib{
    "_",    "and",  "Array",  "as",     "assert", "BINARY",      "Bool", "DECIMAL", "distinct",
    "echo", "exit", "exists", "false",  "forall", "HEXADECIMAL", "iff",  "implies", "Int",
    "is",   "ite",  "let",    "match",  "not",    "NUMERAL",     "or",   "par",     "pop",
    "push", "Real", "reset",  "STRING", "String", "true",        "xor"};

const std::vector<std::pair<std::string, Function>> words_of_facts{
    {"leads", {{"DState", "Action", "DState"}, "Bool"}},
    {"sees", {{"DState", "View"}, "Bool"}},
    {"is_turn", {{"Action"}, "Bool"}},
    {"next", {{"DState", "DState"}, "Bool"}},
    {"opposite", {{"DState", "DState"}, "Bool"}},
    {"ends", {{"DState"}, "Bool"}},
    {"travel", {{}, "Action"}},
    {"turn_around", {{}, "Action"}},
    {"turn_clockwise", {{}, "Action"}},
    {"place", {{"DState"}, "Place"}},
    {"along", {{"DState"}, "DirectedPath"}}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

std::string declaration(const std::string& name, const Function& function) {
  if (function.arguments.empty()) return "(declare-const " + name + " " + function.result + ")";
  std::string sorts;
  for (const std::string& sort : function.arguments) sorts += (sorts.empty() ? "" : " ") + sort;
  return "(declare-fun " + name + " (" + sorts + ") " + function.result + ")";
}

}  // namespace

std::optional<std::string> fault_of_name(const std::string& name) {
  const bool is_word =
      !name.empty() && is_letter(name.front()) &&
      std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
  if (!is_word) return "a name of letters, digits and _";
  if (words_of_smt_lib.contains(name)) return "a name that is no word of SMT-LIB";
  return std::nullopt;
}

bool is_name_of_fact(const std::string& name) {
  const auto digits_end = [&](std::size_t at) {
    while (at < name.size() && is_digit(name[at])) ++at;
    return at;
  };
  const std::size_t end = digits_end(1);
  if (end == 1) return false;
  if (name.front() == 'v' || name.front() == 'a') return end == name.size();
  return name.front() == 'd' && end < name.size() && name[end] == '_' &&
         digits_end(end + 1) > end + 1 && digits_end(end + 1) == name.size();
}

void require_vocabulary(const std::map<std::string, AxiomSet::Function>& functions,
                        const std::string& where) {
  for (const auto& [name, function] : words_of_facts) {
    const auto declared = functions.find(name);
    if (declared == functions.end())
      throw InputError(where, "no declaration of " + name, declaration(name, function));
    if (declared->second != function)
      throw InputError(where, declaration(name, declared->second), declaration(name, function));
  }
  for (const auto& [name, function] : functions)
    for (const std::string sort : {"DState", "Action", "View"})
      if (function.result == sort && !function.arguments.empty())
        throw InputError(where, declaration(name, function),
                         "no function to " + sort + ", since its constants are named apart");
}

}  // namespace asterism
