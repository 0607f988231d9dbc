#include <fmt/format.h>
#include <lzma.h>
#include <png.h>
#include <zlib.h>
#include <boost/version.hpp>

#include <CLI/Version.hpp>

#include "axioms/axiom_solver.hpp"
#include "cli/text/version_text.hpp"
#include "io/json/json_value.hpp"

namespace asterism {

std::string version_text() {
  return fmt::format(
      "asterism {}\nz3 {}\nboost {}.{}.{}\nnlohmann-json {}\nfmt {}.{}.{}\ncli11 {}\n"
      "zlib {}\nliblzma {}\nlibpng {}",
      ASTERISM_VERSION, solver_version(), BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
      BOOST_VERSION % 100, json_parser_version(), FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
      FMT_VERSION % 100, CLI11_VERSION, zlibVersion(), lzma_version_string(),
      png_get_libpng_ver(nullptr));
}

}  // namespace asterism
