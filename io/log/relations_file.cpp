#include "io/log/relations_file.hpp"

#include <istream>

#include "core/error.hpp"
#include "io/line_words.hpp"
#include "io/text_file.hpp"

namespace asterism {

std::vector<Relation> read_relations(std::unique_ptr<std::istream> in, const std::string& name) {
  LineReader lines(std::move(in), name);
  std::vector<Relation> result;
  while (auto line = next_data_line(lines)) {
    Relation relation;
    relation.first_stamp_s = line->number("t1");
    relation.second_stamp_s = line->number("t2");
    Pose2& pose = relation.first_from_second;
    pose.x_m = line->number("x", position_bounds_m);
    pose.y_m = line->number("y", position_bounds_m);
    for (const char* name_of_0 : {"z", "roll", "pitch"}) line->planar_zero(name_of_0);
    pose.heading_rad = wrapped(line->number("yaw", heading_bounds_rad));
    line->end("yaw");
    result.push_back(relation);
  }
  if (result.empty()) throw InputError(name, "no relation", "at least one");
  return result;
}

std::vector<Relation> read_relations_file(const std::string& file) {
  return read_relations(opened_file(file), file);
}

}  // namespace asterism
