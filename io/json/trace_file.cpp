#include "io/json/trace_file.hpp"

#include <stdexcept>
#include <utility>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/json/experience_json.hpp"
#include "io/json/json_node.hpp"
#include "io/json/json_writer.hpp"
#include "io/json/visit_json.hpp"
#include "io/text_file.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;

Trace read_visits(const JsonNode& root, const std::string& file_name) {
  root.require_keys({"format", "version", "kind", "name", "visits"}, Extensions::allowed);
  Trace trace{root["name"].string(), root["visits"].list(read_visit), root.extensions()};
  try {
    require_valid(trace);
  } catch (const std::invalid_argument& error) {
    throw InputError(file_name + ':' + error.what());
  }
  return trace;
}

Experience read_experience(const JsonNode& root) {
  root.require_keys({"format", "version", "kind", "name", "experience"}, Extensions::allowed);
  auto [views, actions] = read_steps(root["experience"]);
  return {root["name"].string(), std::move(views), std::move(actions), root.extensions()};
}

std::string unchecked_json(const Trace& trace) {
  return json_file("asterism/trace", [&](JsonWriter& json) {
    json.member("name", trace.name);
    write_extensions(json, trace.extensions);
    json.line().key("visits").lines(trace.visits, write_visit);
  });
}

std::string unchecked_json(const Experience& experience) {
  return json_file("asterism/trace", [&](JsonWriter& json) {
    json.member("kind", "ssh", "name", experience.name);
    write_extensions(json, experience.extensions);
    write_steps(json.line().key("experience"), experience);
  });
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

AnyTrace read_any_trace(std::string_view json_text, const std::string& file_name) {
  if (json_text.size() > max_trace_bytes)
    throw InputError(file_name, std::to_string(json_text.size()) + " bytes",
                     "at most " + std::to_string(max_trace_bytes));
  const JsonDocument document{file_name, parse_json(json_text, file_name)};
  const JsonNode root(document);
  root.require_format("asterism/trace");
  const JsonNode kind = root["kind"];
  if (kind.exists() && kind.text() == "\"ssh\"") return read_experience(root);
  if (kind.exists() && kind.text() != "\"hssh\"") kind.refuse("\"hssh\" or \"ssh\"");
  return read_visits(root, file_name);
}

Trace read_trace(std::string_view json_text, const std::string& file_name) {
  AnyTrace trace = read_any_trace(json_text, file_name);
  if (Trace* visits = std::get_if<Trace>(&trace)) return std::move(*visits);
  throw InputError(file_name + ":/kind", "\"ssh\"", "\"hssh\", a trace with stars");
}

AnyTrace read_any_trace_file(const std::string& file) {
  return read_any_trace(read_text_file(file, max_trace_bytes), file);
}

Trace read_trace_file(const std::string& file) {
  return read_trace(read_text_file(file, max_trace_bytes), file);
}

std::string trace_json(const Trace& trace) { return checked_json(trace); }
std::string trace_json(const Experience& experience) { return checked_json(experience); }

void write_trace_file(const std::string& file, const Trace& trace) {
  write_atomically(file, trace_json(trace));
}

}  // namespace asterism
