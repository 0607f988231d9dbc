#include "axioms/least_closure.hpp"
#include "axioms/smt2_text.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/fuzz.hpp"

namespace {

using namespace asterism;

/// Any text is axioms or refused. What is read can be grounded, or is refused then.
void check(const AxiomFiles& files) {
  const auto text = accepted("", [&] {
    const AxiomSet axioms = AxiomSet::parse(files);
    static_cast<void>(axioms.is_shipped());
    const std::vector<Fact> facts{{"leads", {"d0_0", "travel", "d1_0"}},
                                  {"opposite", {"d1_0", "d1_1"}},
                                  {"opposite", {"d1_1", "d1_0"}},
                                  {"next", {"d1_0", "d1_1"}},
                                  {"sees", {"d1_0", "v0"}},
                                  {"ends", {"d1_1"}},
                                  {"is_turn", {"turn_around"}}};
    // What is read can be counted too, where there is something to count in.
    if (LeastClosure::exists(axioms))
      require(LeastClosure(axioms, facts).minimised().size() == axioms.minimised().size());
    return smt2_text(axioms, facts, "input");
  });
  require(text != "");
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
  const std::string text = fuzz_input(data, size);
  check({{"user.smt2", text}});
  AxiomFiles files = declarations;
  files["user.smt2"] = text;
  check(files);
  return 0;
}
