#include "io/json/checkpoint_file.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>
#include <tuple>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/json/assumption_json.hpp"
#include "io/json/digest.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"
#include "io/json/trace_file.hpp"
#include "io/shown.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

using Decision = SearchState::Decision;
using Model = SearchState::Model;

// There may be millions of these: lists in strings take a tenth of the memory to read.

std::string text_of(ArmId arm) { return std::to_string(arm.index()); }

std::string text_of(const Decision& decision) {
  return text_of(decision.arm) + (decision.same ? '=' + text_of(*decision.same) : "");
}

template <class Part>
std::string text_of(const std::vector<Part>& parts) {
  std::string text;
  for (const Part& part : parts) text += (text.empty() ? "" : " ") + text_of(part);
  return text;
}

/// Takes the number of an arm off the front of a text.
std::optional<ArmId> take_arm(std::string_view& text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto digits = static_cast<std::size_t>(end - text.data());
  if (error != std::errc() || (digits > 1 && text.front() == '0')) return std::nullopt;
  text.remove_prefix(digits);
  return ArmId(number);
}

bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<Decision> take_decision(std::string_view& text) {
  const auto arm = take_arm(text);
  if (!arm) return std::nullopt;
  if (!take(text, '=')) return Decision{*arm};
  const auto same = take_arm(text);
  return same ? std::optional(Decision{*arm, same}) : std::nullopt;
}

/// A list in a string, which must be written as above, to the space.
template <class Part>
std::vector<Part> read_parts(const JsonNode& node, const std::string& expected,
                             std::optional<Part> (*take_part)(std::string_view&)) {
  std::vector<Part> parts;
  std::string_view text = node.string();
  while (!text.empty()) {
    const bool goes_on = parts.empty() || take(text, ' ');
    const auto part = goes_on ? take_part(text) : std::nullopt;
    if (!part) node.refuse(expected);
    parts.push_back(*part);
  }
  return parts;
}

Model read_model(const JsonNode& node) {
  auto model = read_parts(node, "numbers of arms with spaces between", take_arm);
  if (model.empty()) node.refuse("numbers of arms, one a visit");
  return model;
}

std::vector<Decision> read_decisions(const JsonNode& node) {
  return read_parts(node, "decisions \"5\" or \"5=2\" with spaces between", take_decision);
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

Checkpoint::Search read_search(const JsonNode& root) {
  Checkpoint::Search search;
  search.trace = root["trace"].string();
  search.digest = read_digest(root["digest"]);
  const JsonNode options = root["options"];
  options.require_keys({"planar", "optional_axioms", "preference", "assumptions"});
  search.theory.planar = options["planar"].boolean();
  search.theory.optional_axioms = options["optional_axioms"].list(&JsonNode::string);
  search.theory.preference = options["preference"].list(&JsonNode::string);
  search.theory.assumptions = read_assumptions(options["assumptions"]);
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
    item.require_keys({"decided", "next"});
    state.branches.push_back({read_decisions(item["decided"]), read_decisions(item["next"])});
    if (state.branches.back().next.empty()) item["next"].refuse("at least one decision");
  }
  return state;
}

}  // namespace

void write_checkpoint(std::ostream& out, const Checkpoint& checkpoint) {
  const auto& [search, state] = checkpoint;
  JsonWriter json;
  json.object([&] {
    json.member("format", "asterism/checkpoint", "version", 1, "trace", search.trace, "digest",
                search.digest);
    json.line().key("options").object([&] {
      json.member("planar", search.theory.planar, "optional_axioms", search.theory.optional_axioms,
                  "preference", search.theory.preference);
      write_assumptions(json, search.theory.assumptions);
    });
    json.line().member("level_begun", state.is_level_begun, "limit", state.limit, "refused",
                       state.refused);
    json.line().key("incumbent");
    state.incumbent ? json.value(text_of(*state.incumbent)) : json.null();
    json.line().key("models").tight().lines(state.models, [&](JsonWriter& to, const Model& model) {
      to.value(text_of(model));
      out << to.take();
    });
    json.line()
        .key("branches")
        .tight()
        .lines(state.branches, [&](JsonWriter& to, const auto& branch) {
          to.object("decided", text_of(branch.decided), "next", text_of(branch.next));
          out << to.take();
        });
  });
  out << json.take() << '\n';
}

void write_checkpoint_file(const std::string& file, const Checkpoint& checkpoint) {
  write_atomically(file, [&](std::ostream& out) { write_checkpoint(out, checkpoint); });
}

Checkpoint read_checkpoint(std::string_view json_text, const std::string& file_name) {
  const JsonDocument document{file_name, parse_json(json_text, file_name)};
  const JsonNode root(document);
  root.require_format("asterism/checkpoint");
  root.require_keys({"format", "version", "trace", "digest", "options", "level_begun", "limit",
                     "refused", "incumbent", "models", "branches"});
  return {read_search(root), read_state(root)};
}

Checkpoint read_checkpoint_file(const std::string& file) {
  return read_checkpoint(read_text_file(file, max_checkpoint_bytes), file);
}

void require_same_search(const Checkpoint& checkpoint, const Checkpoint::Search& expected,
                         const std::string& file_name) {
  constexpr std::size_t max_shown = 120;
  const auto& found = checkpoint.search;
  const auto require = [&](const char* where, const auto& is, const auto& must_be) {
    if (is != must_be)
      throw InputError(file_name + ":/" + where, printable(json_of(is), max_shown),
                       printable(json_of(must_be), max_shown) + " as in the search to go on with");
  };
  const TheoryRecord& theory = found.theory;
  const TheoryRecord& wanted = expected.theory;
  require("digest", found.digest, expected.digest);
  require("options/planar", theory.planar, wanted.planar);
  require("options/optional_axioms", theory.optional_axioms, wanted.optional_axioms);
  require("options/preference", theory.preference, wanted.preference);
  require("options/assumptions", assumption_texts(theory.assumptions),
          assumption_texts(wanted.assumptions));
}

}  // namespace asterism
