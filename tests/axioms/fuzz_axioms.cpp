#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "axioms/axiom_solver.hpp"
#include "core/error.hpp"
#include "tests/support/axiom_files.hpp"

namespace {

using namespace asterism;

/// Any text is axioms or refused, in one line. What is read can be grounded.
void check(const AxiomFiles& files) {
  try {
    const AxiomSet axioms = AxiomSet::parse(files);
    static_cast<void>(axioms.is_shipped());
    const std::vector<Fact> facts{{"leads", {"d0_0", "travel", "d1_0"}},
                                  {"opposite", {"d1_0", "d1_1"}},
                                  {"opposite", {"d1_1", "d1_0"}},
                                  {"next", {"d1_0", "d1_1"}},
                                  {"sees", {"d1_0", "v0"}},
                                  {"ends", {"d1_1"}},
                                  {"is_turn", {"turn_around"}}};
    if (smt2_text(axioms, facts, "input").empty()) std::abort();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    if (message.find('\n') != std::string_view::npos) std::abort();
    if (message.find(": found ") == std::string_view::npos) std::abort();
    if (message.find("; expected ") == std::string_view::npos) std::abort();
  }
}

}  // namespace

/// The text stands by itself, and beside what the shipped files declare.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const AxiomFiles declarations = [] {
    AxiomFiles files = shipped_files();
    files.erase("preference.smt2");
    for (auto& [name, text] : files)
      for (std::size_t at; (at = text.find("(assert")) != std::string::npos;)
        text.erase(at, text.find("))\n", text.find(":named", at)) + 2 - at);
    return files;
  }();
  const std::string text(reinterpret_cast<const char*>(data), size);
  check({{"user.smt2", text}});
  AxiomFiles files = declarations;
  files["user.smt2"] = text;
  check(files);
  return 0;
}
