#include "io/trace_file.hpp"

#include <stdexcept>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/json_node.hpp"
#include "io/text_file.hpp"
#include "io/visit_json.hpp"

namespace asterism {
Trace read_trace(std::string_view json_text, const std::string& file_name) {
  if (json_text.size() > max_trace_bytes)
    throw InputError(file_name, std::to_string(json_text.size()) + " bytes",
                     "at most " + std::to_string(max_trace_bytes));
  const JsonDocument document{file_name, parse_json(json_text, file_name)};
  const JsonNode root(document);
  root["format"].require("\"asterism/trace\"");
  root["version"].require("1");
  // Basic SSH, "ssh", tells views and actions in place of visits.
  if (const auto kind = root["kind"]; kind.exists()) kind.require("\"hssh\"");
  root.require_keys({"format", "version", "kind", "name", "visits"}, JsonNode::Extensions::allowed);

  Trace trace{root["name"].string(), {}, root.extensions()};
  for (const JsonNode& visit : root["visits"].items()) trace.visits.push_back(read_visit(visit));
  try {
    require_valid(trace);
  } catch (const std::invalid_argument& error) {
    throw InputError(file_name + ':' + error.what());
  }
  return trace;
}

Trace read_trace_file(const std::string& file) {
  return read_trace(read_text_file(file, max_trace_bytes), file);
}

void write_trace_file(const std::string& file, const Trace& trace) {
  write_atomically(file, trace_json(trace));
}

}  // namespace asterism
