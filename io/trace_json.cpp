#include <stdexcept>

#include "core/error.hpp"
#include "io/experience_json.hpp"
#include "io/json_value.hpp"
#include "io/pose_json.hpp"
#include "io/trace_file.hpp"

namespace asterism {
namespace {

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string result;
  for (const std::string& part : parts) result += (&part == &parts.front() ? "" : separator) + part;
  return result;
}

template <class Range>
std::string list(const Range& numbers) {
  std::vector<std::string> texts;
  for (const auto number : numbers) {
    if constexpr (std::is_same_v<decltype(number), const double>)
      texts.push_back(json_number(number));
    else
      texts.push_back(std::to_string(number));
  }
  return '[' + joined(texts, ", ") + ']';
}

/// The members of a JSON object, given as text, in a list of their own lines.
void append_members(const std::string& object, std::vector<std::string>& lines) {
  const JsonValue value = parse_json(object, "extensions");
  const auto* members = std::get_if<JsonValue::Object>(&value.content);
  if (!members)
    throw std::invalid_argument("extensions: found " + shown(object) + "; expected an object");
  for (const auto& [key, content] : *members)
    lines.push_back(json_quoted(key) + ": " + json_text(content));
}

std::string displacement_json(const Displacement& displacement) {
  const auto& [x_m, y_m, heading_rad, covariance] = displacement;
  return "{ " + pose_members({x_m, y_m, heading_rad}, covariance) + " }";
}

std::string gateway_json(const MeasuredGateway& gateway) {
  return "{ \"arm\": " + json_quoted(gateway.arm) + ", \"x_m\": " + json_number(gateway.x_m) +
         ", \"y_m\": " + json_number(gateway.y_m) +
         ", \"heading_rad\": " + json_number(gateway.heading_rad) +
         ", \"width_m\": " + json_number(gateway.width_m) + " }";
}

std::string visit_json(const Visit& visit) {
  std::vector<std::string> symbols{"\"star\": " + json_quoted(visit.star.text())};
  if (visit.entered_by)
    symbols.push_back("\"entered_by\": " + json_quoted(visit.star.name(*visit.entered_by)));
  if (visit.left_by)
    symbols.push_back("\"left_by\": " + json_quoted(visit.star.name(*visit.left_by)));
  if (visit.true_place) symbols.push_back("\"true_place\": " + json_quoted(*visit.true_place));

  std::vector<std::string> lines{joined(symbols, ", ")};
  if (visit.displacement)
    lines.push_back("\"displacement\": " + displacement_json(*visit.displacement));
  if (visit.scans) lines.push_back("\"scans\": " + list(*visit.scans));
  if (visit.stamps_s) lines.push_back("\"stamps_s\": " + list(*visit.stamps_s));
  if (visit.lpm) lines.push_back("\"lpm\": " + json_quoted(*visit.lpm));
  if (!visit.gateways.empty()) {
    std::vector<std::string> gateways;
    for (const MeasuredGateway& gateway : visit.gateways) gateways.push_back(gateway_json(gateway));
    lines.push_back("\"gateways\": [\n        " + joined(gateways, ",\n        ") + " ]");
  }
  append_members(visit.extensions, lines);
  return "    { " + joined(lines, ",\n      ") + " }";
}

std::string unchecked_json(const Trace& trace) {
  std::vector<std::string> lines{"\"format\": \"asterism/trace\", \"version\": 1, \"name\": " +
                                 json_quoted(trace.name)};
  append_members(trace.extensions, lines);
  std::vector<std::string> visits;
  for (const Visit& visit : trace.visits) visits.push_back(visit_json(visit));
  lines.push_back("\"visits\": [\n" + joined(visits, ",\n") + " ]");
  return "{ " + joined(lines, ",\n  ") + " }\n";
}

std::string unchecked_json(const Experience& experience) {
  std::vector<std::string> lines{
      "\"format\": \"asterism/trace\", \"version\": 1, \"kind\": \"ssh\", \"name\": " +
      json_quoted(experience.name)};
  append_members(experience.extensions, lines);
  lines.push_back("\"experience\": " + steps_json(experience));
  return "{ " + joined(lines, ",\n  ") + " }\n";
}

template <class AnyKind>
std::string checked_json(const AnyKind& trace) {
  require_valid(trace);
  try {
    std::string text = unchecked_json(trace);
    read_any_trace(text, "trace");  // the reader is the judge of what may be written
    return text;
  } catch (const InputError& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace

std::string trace_json(const Trace& trace) { return checked_json(trace); }
std::string trace_json(const Experience& experience) { return checked_json(experience); }

}  // namespace asterism
