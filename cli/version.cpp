#include <fmt/format.h>
#include <lzma.h>
#include <png.h>
#include <z3.h>
#include <zlib.h>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include <CLI/Version.hpp>

#include "cli/options.hpp"

namespace asterism {

std::string version_text() {
  return fmt::format(
      "asterism {}\nz3 {}\nboost {}.{}.{}\nnlohmann-json {}.{}.{}\nfmt {}.{}.{}\ncli11 {}\n"
      "zlib {}\nliblzma {}\nlibpng {}",
      ASTERISM_VERSION, Z3_get_full_version(), BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
      BOOST_VERSION % 100, NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
      NLOHMANN_JSON_VERSION_PATCH, FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
      CLI11_VERSION, zlibVersion(), lzma_version_string(), png_get_libpng_ver(nullptr));
}

}  // namespace asterism
