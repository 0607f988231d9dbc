#include "io/checkpoint_file.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "io/assumption_json.hpp"
#include "io/atomic_file.hpp"
#include "io/json_node.hpp"
#include "io/text_file.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;
using Decision = SearchState::Decision;
using Model = SearchState::Model;

std::string json_of(bool value) { return value ? "true" : "false"; }

std::string json_of(const std::vector<std::string>& names) {
  std::string text = "[";
  for (const std::string& name : names) text += (text.size() == 1 ? "" : ", ") + json_quoted(name);
  return text + ']';
}

// There may be millions of these: lists in strings take a tenth of the memory to read.

std::string text_of(std::uint32_t arm) { return std::to_string(arm); }

std::string text_of(const Decision& decision) {
  return std::to_string(decision.arm) + (decision.same ? '=' + std::to_string(*decision.same) : "");
}

template <class Part>
std::string json_of(const std::vector<Part>& parts) {
  std::string text = "\"";
  for (const Part& part : parts) text += (text.size() == 1 ? "" : " ") + text_of(part);
  return text + '"';
}

/// Takes a number off the front of a text.
std::optional<std::uint32_t> take_number(std::string_view& text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto digits = static_cast<std::size_t>(end - text.data());
  if (error != std::errc() || (digits > 1 && text.front() == '0')) return std::nullopt;
  text.remove_prefix(digits);
  return number;
}

bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

bool take_part(std::string_view& text, std::uint32_t& arm) {
  const auto number = take_number(text);
  arm = number.value_or(0);
  return number.has_value();
}

bool take_part(std::string_view& text, Decision& decision) {
  if (!take_part(text, decision.arm)) return false;
  if (!take(text, '=')) return true;
  decision.same = take_number(text);
  return decision.same.has_value();
}

/// A list in a string, which must be written as above, to the space.
template <class Part>
std::vector<Part> read_parts(const JsonNode& node, const std::string& expected) {
  std::vector<Part> parts;
  std::string_view text = node.string();
  while (!text.empty()) {
    Part part{};
    if ((!parts.empty() && !take(text, ' ')) || !take_part(text, part)) node.refuse(expected);
    parts.push_back(part);
  }
  return parts;
}

Model read_model(const JsonNode& node) {
  auto model = read_parts<std::uint32_t>(node, "numbers of arms with spaces between");
  if (model.empty()) node.refuse("numbers of arms, one a visit");
  return model;
}

std::vector<Decision> read_decisions(const JsonNode& node) {
  return read_parts<Decision>(node, "decisions \"5\" or \"5=2\" with spaces between");
}

/// Maps are of one trace; none is there twice, or it would be counted twice.
std::vector<Model> read_models(const JsonNode& node, std::optional<std::size_t> visits) {
  std::vector<Model> models;
  const auto items = node.items();
  models.reserve(items.size());
  for (const JsonNode& item : items) {
    models.push_back(read_model(item));
    if (models.back().size() != visits.value_or(models.front().size()))
      item.refuse(std::to_string(models.back().size()) + " arms",
                  std::to_string(visits.value_or(models.front().size())) +
                      " as in the map before, one a visit");
  }
  std::vector<std::size_t> order(models.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return std::tie(models[a], a) < std::tie(models[b], b);
  });
  const auto twice = std::ranges::adjacent_find(
      order, [&](std::size_t a, std::size_t b) { return models[a] == models[b]; });
  if (twice != order.end()) items[*std::next(twice)].refuse("a map again", "each map once");
  return models;
}

std::vector<std::string> read_names(const JsonNode& node) {
  std::vector<std::string> names;
  for (const JsonNode& item : node.items()) names.push_back(item.string());
  return names;
}

Checkpoint::Search read_search(const JsonNode& root) {
  Checkpoint::Search search;
  search.trace = root["trace"].string();
  search.digest = root["digest"].string();
  if (search.digest.size() != 16 ||
      search.digest.find_first_not_of("0123456789abcdef") != std::string::npos)
    root["digest"].refuse("16 hexadecimal digits");
  const JsonNode options = root["options"];
  options.require_keys({"planar", "optional_axioms", "preference", "assumptions"},
                       Extensions::refused);
  search.planar = options["planar"].boolean();
  search.optional_axioms = read_names(options["optional_axioms"]);
  search.preference = read_names(options["preference"]);
  if (const auto assumed = options["assumptions"]; assumed.exists())
    search.assumptions = read_assumptions(assumed);
  return search;
}

SearchState read_state(const JsonNode& root) {
  SearchState state;
  state.is_level_begun = root["level_begun"].boolean();
  state.limit = root["limit"].count();
  state.refused = root["refused"].count();
  std::optional<std::size_t> visits;
  if (const auto incumbent = root["incumbent"]; !incumbent.is_null()) {
    state.incumbent = read_model(incumbent);
    visits = state.incumbent->size();
  }
  state.models = read_models(root["models"], visits);
  for (const JsonNode& item : root["branches"].items()) {
    item.require_keys({"decided", "next"}, Extensions::refused);
    state.branches.push_back({read_decisions(item["decided"]), read_decisions(item["next"])});
    if (state.branches.back().next.empty()) item["next"].refuse("at least one decision");
  }
  return state;
}

}  // namespace

std::string digest(const Trace& trace) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : trace_json(trace))
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[hash >> shift & 15];
  return text;
}

void write_checkpoint(std::ostream& out, const Checkpoint& checkpoint) {
  const auto& [search, state] = checkpoint;
  out << "{ \"format\": \"asterism/checkpoint\", \"version\": 1, \"trace\": "
      << json_quoted(search.trace) << ", \"digest\": " << json_quoted(search.digest)
      << ",\n  \"options\": { \"planar\": " << json_of(search.planar)
      << ", \"optional_axioms\": " << json_of(search.optional_axioms)
      << ", \"preference\": " << json_of(search.preference);
  if (!search.assumptions.empty())
    out << ", \"assumptions\": " << json_of(assumption_texts(search.assumptions));
  out << " },\n  \"level_begun\": " << json_of(state.is_level_begun)
      << ", \"limit\": " << std::to_string(state.limit)
      << ", \"refused\": " << std::to_string(state.refused)
      << ",\n  \"incumbent\": " << (state.incumbent ? json_of(*state.incumbent) : "null")
      << ",\n  \"models\": [";
  for (const Model& model : state.models)
    out << (&model == state.models.data() ? "\n    " : ",\n    ") << json_of(model);
  out << "],\n  \"branches\": [";
  for (const auto& branch : state.branches)
    out << (&branch == state.branches.data() ? "\n    " : ",\n    ")
        << "{ \"decided\": " << json_of(branch.decided) << ", \"next\": " << json_of(branch.next)
        << " }";
  out << "] }\n";
}

void write_checkpoint_file(const std::string& file, const Checkpoint& checkpoint) {
  write_atomically(file, [&](std::ostream& out) { write_checkpoint(out, checkpoint); });
}

Checkpoint read_checkpoint(std::string_view json_text, const std::string& file_name) {
  const JsonDocument document{file_name, parse_json(json_text, file_name)};
  const JsonNode root(document);
  root["format"].require("\"asterism/checkpoint\"");
  root["version"].require("1");
  root.require_keys({"format", "version", "trace", "digest", "options", "level_begun", "limit",
                     "refused", "incumbent", "models", "branches"},
                    Extensions::refused);
  return {read_search(root), read_state(root)};
}

Checkpoint read_checkpoint_file(const std::string& file) {
  return read_checkpoint(read_text_file(file, max_checkpoint_bytes), file);
}

void require_same_search(const Checkpoint& checkpoint, const Checkpoint::Search& expected,
                         const std::string& file_name) {
  constexpr std::size_t max_shown = 120;
  const auto& found = checkpoint.search;
  const auto require = [&](const char* where, const std::string& is, const std::string& must_be) {
    if (is != must_be)
      throw InputError(file_name + ":/" + where, printable(is, max_shown),
                       printable(must_be, max_shown) + " as in the search to go on with");
  };
  const auto assumed = [](const std::vector<Assumption>& assumptions) {
    return json_of(assumption_texts(assumptions));
  };
  require("digest", json_quoted(found.digest), json_quoted(expected.digest));
  require("options/planar", json_of(found.planar), json_of(expected.planar));
  require("options/optional_axioms", json_of(found.optional_axioms),
          json_of(expected.optional_axioms));
  require("options/preference", json_of(found.preference), json_of(expected.preference));
  require("options/assumptions", assumed(found.assumptions), assumed(expected.assumptions));
}

}  // namespace asterism
