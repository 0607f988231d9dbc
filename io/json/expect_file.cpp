#include "io/json/expect_file.hpp"

#include <algorithm>

#include "io/json/assumption_json.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"
#include "io/shown.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

void write_options(JsonWriter& json, const TheoryRecord& theory) {
  json.object([&] {
    json.member("planar", theory.planar);
    if (!theory.optional_axioms.empty()) json.member("optional_axioms", theory.optional_axioms);
    write_assumptions(json, theory.assumptions);
  });
}

void write_minimal(JsonWriter& json, const std::optional<Expectation::Minimal>& minimal) {
  if (!minimal) return json.null();
  json.object([&] {
    json.member("paths", minimal->paths, "places", minimal->places, "count", minimal->count);
    json.line().key("visits").tight().lines(minimal->visits);
  });
}

void write_question(JsonWriter& json, const Expectation::Question& question) {
  json.object([&] {
    json.member("query", question.query);
    if (question.only_minimal) json.member("over", "minimal");
    if (!question.answer) return;
    json.member("verdict", verdict_of(*question.answer), "holds", question.answer->holds, "of",
                question.answer->of);
  });
}

void write_case(JsonWriter& json, const Expectation::Case& one) {
  json.object([&] {
    write_options(json.key("options"), one.theory);
    if (one.counts) {
      json.line().member("consistent", one.counts->per_visit.back());
      json.line().member("per_visit", one.counts->per_visit);
      write_minimal(json.line().key("minimal"), one.counts->minimal);
    }
    if (!one.queries.empty()) json.line().key("queries").lines(one.queries, write_question);
  });
}

using Names = std::vector<std::string>;

Names read_names(const JsonNode& node) {
  Names names;
  for (const JsonNode& item : node.items()) {
    if (item.string().empty()) item.refuse("a name");
    if (!names.empty() && item.string() <= names.back())
      item.refuse(item.found() + " after " + shown(names.back()), "each name once, sorted");
    names.push_back(item.string());
  }
  if (names.empty()) node.refuse("an empty array", "a name, or no such key");
  return names;
}

TheoryRecord read_theory(const JsonNode& node) {
  node.require_keys({"planar", "optional_axioms", "assumptions"});
  TheoryRecord theory;
  theory.planar = node["planar"].boolean();
  theory.optional_axioms = node["optional_axioms"].if_exists(read_names).value_or(Names());
  theory.assumptions = read_assumptions(node["assumptions"]);
  return theory;
}

/// The place of each visit of a model: numbered by first visit.
std::vector<PlaceId> read_model(const JsonNode& node, std::size_t visits, std::size_t places) {
  std::vector<PlaceId> model;
  std::size_t known = 0;
  for (const JsonNode& item : node.items(visits, "places, one a visit")) {
    model.emplace_back(item.count(known));
    known = std::max(known, model.back().index() + 1);
  }
  if (known != places)
    node.refuse(std::to_string(known) + " places", std::to_string(places) + " as in minimal");
  return model;
}

Expectation::Minimal read_minimal(const JsonNode& node, const Expectation::Counts& counts,
                                  const TheoryRecord& theory) {
  node.require_keys({"paths", "places", "count", "visits"});
  Expectation::Minimal minimal{node["paths"].count(), node["places"].count(),
                               node["count"].count(counts.per_visit.back())};
  if (minimal.paths == 0) node["paths"].refuse("at least 1");
  if (minimal.count == 0) node["count"].refuse("at least 1");
  const std::size_t spelt_out = std::min<std::uint64_t>(minimal.count, max_expected_models);
  for (const JsonNode& item : node["visits"].items(spelt_out, "models")) {
    minimal.visits.push_back(read_model(item, counts.per_visit.size(), minimal.places));
    const auto& model = minimal.visits.back();
    if (minimal.visits.size() > 1 && model < minimal.visits[minimal.visits.size() - 2])
      item.refuse("a model before the one before", "models sorted by visits");
    for (const Assumption& assumption : theory.assumptions)
      if (!agrees(assumption, model[assumption.one.index()], model[assumption.other.index()]))
        item.refuse("a model that is not so", text_of(assumption) + " as assumed");
  }
  return minimal;
}

Expectation::Counts read_counts(const JsonNode& node, const TheoryRecord& theory) {
  Expectation::Counts counts;
  const auto per_visit = node["per_visit"];
  for (const JsonNode& number : per_visit.items()) {
    counts.per_visit.push_back(number.count());
    if (counts.per_visit.size() > 1 && number.count() > 0 && counts.per_visit.rbegin()[1] == 0)
      number.refuse("0, since no map is left before");
  }
  if (counts.per_visit.empty()) per_visit.refuse("an empty array", "a number a visit");
  const std::uint64_t last = counts.per_visit.back();
  if (const auto consistent = node["consistent"]; consistent.count() != last)
    consistent.refuse(std::to_string(last) + ", the last of per_visit");
  const auto assumed = node["options"]["assumptions"];
  for (std::size_t i = 0; i < theory.assumptions.size(); ++i) {
    const Assumption& assumption = theory.assumptions[i];
    if (std::max(assumption.one, assumption.other).index() >= counts.per_visit.size())
      assumed.items()[i].refuse("visits below " + std::to_string(counts.per_visit.size()) +
                                ", as per_visit has");
  }
  const auto minimal = node["minimal"];
  if (minimal.is_null() != (last == 0))
    minimal.refuse(last == 0 ? "null, since no map is consistent"
                             : "an object, since a map is consistent");
  if (last > 0) counts.minimal = read_minimal(minimal, counts, theory);
  return counts;
}

/// How many maps a query is asked of.
std::uint64_t asked(const Expectation::Counts& counts, bool only_minimal) {
  if (!only_minimal) return counts.per_visit.back();
  return counts.minimal ? counts.minimal->count : 0;
}

Expectation::Question read_question(const JsonNode& node,
                                    const std::optional<Expectation::Counts>& counts) {
  node.require_keys({"query", "over", "verdict", "holds", "of"});
  Expectation::Question question;
  question.query = node["query"].string();
  if (const auto over = node["over"]; over.exists()) {
    question.only_minimal = over.string() == "minimal";
    if (!question.only_minimal && over.string() != "all") over.refuse("\"all\" or \"minimal\"");
  }
  if (!node["verdict"].exists() && !node["holds"].exists() && !node["of"].exists()) return question;
  const auto of = node["of"];
  question.answer = {node["holds"].count(of.count()), of.count()};
  if (counts && of.count() != asked(*counts, question.only_minimal))
    of.refuse(std::to_string(asked(*counts, question.only_minimal)) + ", as many as there are");
  if (const auto verdict = node["verdict"]; verdict.string() != verdict_of(*question.answer))
    verdict.refuse('"' + std::string(verdict_of(*question.answer)) + '"');
  return question;
}

Expectation::Case read_case(const JsonNode& node) {
  node.require_keys({"options", "consistent", "per_visit", "minimal", "queries"});
  Expectation::Case one;
  one.theory = read_theory(node["options"]);
  if (node["consistent"].exists() || node["per_visit"].exists() || node["minimal"].exists())
    one.counts = read_counts(node, one.theory);
  if (const auto queries = node["queries"]; queries.exists()) {
    for (const JsonNode& item : queries.items())
      one.queries.push_back(read_question(item, one.counts));
    if (one.queries.empty()) queries.refuse("an empty array", "a query, or no such key");
  }
  return one;
}

}  // namespace

const char* verdict_of(const Expectation::Answer& answer) {
  return answer.holds == 0 ? "impossible" : answer.holds == answer.of ? "certain" : "possible";
}

Expectation read_expectation(std::string_view json_text, const std::string& file_name) {
  const JsonDocument document{file_name, parse_json(json_text, file_name)};
  const JsonNode root(document);
  root.require_format("asterism/expect");
  root.require_keys({"format", "version", "cases"});
  Expectation expectation;
  for (const JsonNode& item : root["cases"].items()) {
    Expectation::Case one = read_case(item);
    if (std::ranges::count(expectation.cases, one.theory, &Expectation::Case::theory) > 0)
      item["options"].refuse("options again", "each options once");
    expectation.cases.push_back(std::move(one));
  }
  if (expectation.cases.empty()) root["cases"].refuse("an empty array", "at least one case");
  return expectation;
}

Expectation read_expect_file(const std::string& file) {
  return read_expectation(read_text_file(file, max_expect_bytes), file);
}

std::string expectation_json(const Expectation& expectation) {
  return json_file("asterism/expect", [&](JsonWriter& json) {
    json.line().key("cases").lines(expectation.cases, write_case);
  });
}

}  // namespace asterism
