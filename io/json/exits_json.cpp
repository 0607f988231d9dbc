#include "io/json/exits_json.hpp"

#include "io/json/json_writer.hpp"

namespace asterism {
namespace {

/// The members that tell a row of travels.
void write_turns(JsonWriter& json, const Visit& last, const std::optional<Turns>& turns) {
  json.member("leave_by", turns ? std::optional(first_arm(last, *turns)) : std::nullopt, "then",
              turns ? std::optional(further(*turns)) : std::nullopt);
}

void write_exit(JsonWriter& json, const Visit& last, const Exit& exit) {
  json.object([&] {
    write_turns(json, last, exit.turns);
    json.member("known", exit.known, "open", exit.open, "expected_left", exit.expected_left,
                "tells", exit.tells);
    json.key("outlooks").list(exit.outlooks, [](JsonWriter& to, const Outlook& outlook) {
      to.object("seen", outlook.seen, "left", outlook.left, "chance", outlook.chance);
    });
  });
}

void write_apart(JsonWriter& json, const Visit& last, const TellingApart& apart) {
  using Answer = TellingApart::Answer;
  const bool is_found = apart.answer == Answer::found;
  json.object([&] {
    json.member("answer", is_found ? "found" : apart.answer == Answer::none ? "none" : "undecided");
    write_turns(json, last,
                is_found && !apart.turns.empty() ? std::optional(apart.turns) : std::nullopt);
    json.member("expected", is_found ? std::optional(apart.expected) : std::nullopt);
  });
}

}  // namespace

std::string exits_json(const ExitsReport& report) {
  const TheoryRecord& theory = report.options.theory;
  const auto write = [&](JsonWriter& json) {
    json.member("trace", report.trace);
    json.key("options").object("planar", theory.planar, "check", report.options.check, "axioms",
                               theory.axioms, "optional_axioms", theory.optional_axioms,
                               "max_travels", report.max_travels, "over",
                               report.only_minimal ? "minimal" : "all");
    json.member("consistent", report.consistent, "complete", !report.stopped_by);
    json.member_if("stopped_by", report.stopped_by);
    json.member("more_exits", report.exits ? std::optional(!report.exits->complete) : std::nullopt,
                "minimal", report.minimal);
    json.key("tell_apart");
    if (!report.exits) {
      json.null();
      json.line().key("exits").null();
      return;
    }
    write_apart(json, report.last, report.apart);
    json.line().key("exits").lines(report.exits->exits, [&](JsonWriter& to, const Exit& exit) {
      write_exit(to, report.last, exit);
    });
  };
  return json_file("asterism/exits", write, JsonWriter::Style::compact);
}

}  // namespace asterism
