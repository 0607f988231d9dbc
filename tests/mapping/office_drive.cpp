#include "tests/mapping/office_drive.hpp"

#include "io/log/carmen_log.hpp"
#include "simulation/drive.hpp"
#include "simulation/office_building.hpp"
#include "tests/io/folder.hpp"

namespace asterism {
namespace {

void write_drive(const std::string& file) {
  RandomEngine engine(6);
  const Building office = office_building({.columns = 3, .rows = 2}, engine);
  const Route route = random_route(office.world, {.travels = 3}, engine);
  Drive drive(office, route, {}, engine());
  write_carmen_log(file, [&] { return drive.next(); });
}

}  // namespace

const std::string& log_of_drive() {
  static const Folder folder;
  static const std::string file = [] {
    write_drive(folder.file("office.log"));
    return folder.file("office.log");
  }();
  return file;
}

}  // namespace asterism
