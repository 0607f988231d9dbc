#include "io/trace_file.hpp"

#include <stdexcept>
#include <utility>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/experience_json.hpp"
#include "io/json_node.hpp"
#include "io/text_file.hpp"
#include "io/visit_json.hpp"

namespace asterism {
namespace {

using Extensions = JsonNode::Extensions;

Trace read_visits(const JsonNode& root, const std::string& file_name) {
  root.require_keys({"format", "version", "kind", "name", "visits"}, Extensions::allowed);
  Trace trace{root["name"].string(), {}, root.extensions()};
  for (const JsonNode& visit : root["visits"].items()) trace.visits.push_back(read_visit(visit));
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

}  // namespace

AnyTrace read_any_trace(std::string_view json_text, const std::string& file_name) {
  if (json_text.size() > max_trace_bytes)
    throw InputError(file_name, std::to_string(json_text.size()) + " bytes",
                     "at most " + std::to_string(max_trace_bytes));
  const JsonDocument document{file_name, parse_json(json_text, file_name)};
  const JsonNode root(document);
  root["format"].require("\"asterism/trace\"");
  root["version"].require("1");
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

void write_trace_file(const std::string& file, const Trace& trace) {
  write_atomically(file, trace_json(trace));
}

}  // namespace asterism
