#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <vector>

#include "axioms/axiom_set.hpp"
#include "core/error.hpp"
#include "tests/support/axiom_files.hpp"
#include "tests/support/catch.hpp"

namespace asterism {
namespace {

const std::filesystem::path corpus = ASTERISM_SOURCE_DIR "/tests/corpus/axioms";

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Why these files are refused.
std::string refusal(const AxiomFiles& files) {
  try {
    AxiomSet::parse(files);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

AxiomFiles shipped_with(const std::string& text) {
  AxiomFiles files = shipped_files();
  files["user.smt2"] = text;
  return files;
}

/// A bad text may set a preference of its own.
AxiomFiles without_preference(AxiomFiles files) {
  files.erase("preference.smt2");
  return files;
}

/// The shipped files with one text in them replaced.
AxiomFiles replaced(const std::string& old_text, const std::string& new_text) {
  AxiomFiles files = shipped_files();
  for (auto& [name, text] : files)
    if (const std::size_t at = text.find(old_text); at != std::string::npos) {
      text.replace(at, old_text.size(), new_text);
      return files;
    }
  throw std::logic_error("nowhere: " + old_text);
}

}  // namespace

TEST_CASE("every bad text is refused, and the message says where and why", "[axioms]") {
  std::ifstream table(corpus / "bad.tsv");
  std::string row;
  std::getline(table, row);
  std::set<std::string> listed;
  while (std::getline(table, row)) {
    const std::size_t tab = row.find('\t');
    const std::string file = row.substr(0, tab);
    INFO(file);
    listed.insert(file);
    CHECK(refusal(without_preference(shipped_with(content(corpus / "bad" / file)))) ==
          row.substr(tab + 1));
  }
  CHECK(listed.size() >= 60);
  for (const auto& entry : std::filesystem::directory_iterator(corpus / "bad"))
    CHECK(listed.contains(entry.path().filename().string()));
}

TEST_CASE("a set without what facts are told in is refused", "[axioms]") {
  // An axiom of a relation goes with its declaration, so that only this is missing.
  const auto without_axioms = [](AxiomFiles files) {
    for (auto& [name, text] : files)
      for (std::size_t at; (at = text.find("(assert")) != std::string::npos;)
        text.erase(at, text.find("))\n", text.find(":named", at)) + 2 - at);
    return files;
  };
  const std::vector<std::string> declarations{"(declare-fun leads (DState Action DState) Bool)",
                                              "(declare-fun sees (DState View) Bool)",
                                              "(declare-fun is_turn (Action) Bool)",
                                              "(declare-fun next (DState DState) Bool)",
                                              "(declare-fun opposite (DState DState) Bool)",
                                              "(declare-fun ends (DState) Bool)",
                                              "(declare-const travel Action)",
                                              "(declare-const turn_around Action)",
                                              "(declare-const turn_clockwise Action)",
                                              "(declare-fun place (DState) Place)",
                                              "(declare-fun along (DState) DirectedPath)"};
  REQUIRE(refusal(without_axioms(shipped_files())) == "not refused");
  for (const std::string& declaration : declarations) {
    const std::size_t space = declaration.find(' ') + 1;
    const std::string name = declaration.substr(space, declaration.find(' ', space) - space);
    CHECK(refusal(without_axioms(replaced(declaration, ""))) ==
          "axioms: found no declaration of " + name + "; expected " + declaration);
    const std::string other = "(declare-fun " + name + " (View) Bool)";
    CHECK(refusal(without_axioms(replaced(declaration, other))) ==
          "axioms: found " + other + "; expected " + declaration);
  }
  CHECK(refusal({}) == "axioms: found no declaration of leads; expected " + declarations.front());
  CHECK(refusal({{"empty.smt2", "; nothing\n"}}) ==
        "axioms: found no declaration of leads; expected " + declarations.front());
}

TEST_CASE("a folder is read with its own optional axioms, and named when it is refused",
          "[axioms]") {
  namespace fs = std::filesystem;
  const fs::path folder =
      fs::temp_directory_path() / ("asterism-" + std::to_string(std::random_device()()));
  fs::create_directories(folder / "optional");
  const auto read = [&](const std::vector<std::string>& optional) -> std::string {
    try {
      const AxiomSet axioms = AxiomSet::read(folder.string(), optional);
      return axioms.is_shipped() ? "shipped" : "other";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  CHECK(read({}) == folder.string() + ": found no *.smt2; expected a folder of axiom files");
  for (const auto& [name, text] : shipped_files()) std::ofstream(folder / name) << text;
  CHECK(read({}) == "shipped");
  CHECK(read({"one_segment"}) == "shipped");
  CHECK(read({"../causal"}) ==
        "optional axiom: found \"../causal\"; expected one of one_crossing, one_segment");
  std::ofstream(folder / "optional/mine.smt2")
      << "(assert (! (forall ((q DState)) (=> (ends q) false)) :named mine))\n";
  CHECK(read({"mine"}) == "other");
  std::ofstream(folder / "topological.smt2") << "(declare-sort Place 0)\n";
  CHECK(read({}) == (folder / "local.smt2").string() +
                        ":21: found (order q r); expected and, or, not, = or a declared relation");
  fs::remove(folder / "topological.smt2");
  fs::remove(folder / "local.smt2");
  CHECK(read({}) == folder.string() +
                        ": found no declaration of is_turn; expected "
                        "(declare-fun is_turn (Action) Bool)");
  fs::remove_all(folder);
  CHECK(read({}).starts_with(folder.string() + ": found "));
}

TEST_CASE("lines may end in CR LF, and a large file is read at once", "[axioms]") {
  AxiomFiles files = shipped_files();
  for (auto& [name, text] : files)
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
      text.replace(at, 1, "\r\n");
  const AxiomSet axioms = AxiomSet::parse(files);
  const AxiomSet shipped = AxiomSet::shipped();
  CHECK(axioms.is_shipped());
  REQUIRE(axioms.axioms().size() == shipped.axioms().size());
  for (std::size_t i = 0; i < shipped.axioms().size(); ++i) {
    CHECK(axioms.axioms()[i].words == shipped.axioms()[i].words);
    CHECK(axioms.axioms()[i].line == shipped.axioms()[i].line);
  }
  std::string many;
  for (int i = 0; i < 2000; ++i)
    many += "; a comment\n(declare-const place_" + std::to_string(i) + " Place)\n";
  CHECK(AxiomSet::parse(shipped_with(many)).functions().size() ==
        shipped.functions().size() + 2000);
}

TEST_CASE("every shipped axiom says where it is from, in words and as a formula", "[axioms]") {
  const AxiomSet axioms = AxiomSet::shipped(AxiomSet::optional_names());
  CHECK(axioms.axioms().size() == 19);
  for (const Axiom& axiom : axioms.axioms()) {
    INFO(axiom.name);
    CHECK(axiom.source.starts_with("["));
    CHECK(axiom.words.ends_with("."));
    CHECK_FALSE(axiom.formula.empty());
  }
  CHECK(axioms.preference() == std::vector<std::string>{"path", "place"});
}

TEST_CASE("order of files, comments and names of variables do not make other axioms", "[axioms]") {
  const auto parse = [](const std::string& text) { return AxiomSet::parse({{"all.smt2", text}}); };
  std::string forward, backward, bare;
  for (const auto& [name, text] : shipped_files()) {
    forward += text;
    backward = text + "\n" + backward;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at) + 1;
      bare += text.substr(at, std::min(text.find(';', at), end) - at) + "\n";
      at = end;
    }
  }
  CHECK(parse(forward).is_shipped());
  CHECK(parse(backward).is_shipped());
  CHECK(parse(bare).is_shipped());
  CHECK(
      AxiomSet::parse(with_axiom(shipped_files(), "transitive",
                                 "(assert (! (forall ((x DState) (y DState) (z DState)) (=> "
                                 "(and (order x y) (order y z)) (order x z))) :named transitive))"))
          .is_shipped());
  CHECK(AxiomSet::shipped(AxiomSet::optional_names()).is_shipped());
  CHECK(parse(forward + "(declare-sort Room 0)").is_shipped());
}

TEST_CASE("a changed, missing, added or renamed axiom makes other axioms", "[axioms]") {
  const auto with_transitive = [](const std::string& formula) {
    return AxiomSet::parse(with_axiom(shipped_files(), "transitive",
                                      "(assert (! (forall ((q DState) (r DState) (s DState)) " +
                                          formula + ") :named transitive))"));
  };
  const std::string formula = "(=> (and (order q r) (order r s)) (order q s))";
  CHECK(with_transitive(formula).is_shipped());
  AxiomFiles renamed = with_axiom(shipped_files(), "transitive");
  renamed["user.smt2"] =
      "(assert (! (forall ((q DState) (r DState) (s DState)) " + formula + ") :named through))";
  CHECK_FALSE(AxiomSet::parse(renamed).is_shipped());
  CHECK_FALSE(with_transitive("(=> (and (order q r) (order r s)) (order s q))").is_shipped());
  CHECK_FALSE(
      with_transitive("(=> (and (order q r) (order r s) (ends q)) (order q s))").is_shipped());
  const AxiomSet shipped = AxiomSet::shipped();
  for (const Axiom& axiom : shipped.axioms())
    if (!axiom.by_signature)
      CHECK_FALSE(AxiomSet::parse(with_axiom(shipped_files(), axiom.name)).is_shipped());
  CHECK_FALSE(AxiomSet::parse(shipped_with("(assert (! (forall ((q DState)) (=> (ends q) false)) "
                                           ":named mine))"))
                  .is_shipped());
  CHECK_FALSE(AxiomSet::parse(shipped_with("(declare-const home Place)")).is_shipped());
}

}  // namespace asterism
