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
  CHECK(axioms.preference() == std::vector{Extent::path, Extent::place});
}

TEST_CASE("every shipped extent says where it is from, in words and as a formula", "[axioms]") {
  const AxiomSet axioms = AxiomSet::shipped();
  REQUIRE(axioms.extents().size() == all_extents.size());
  for (const ExtentDeclaration& extent : axioms.extents()) {
    INFO(extent.name);
    CHECK(extent.known == extent_named(extent.name));
    CHECK(extent.source.starts_with("["));
    CHECK(extent.words.ends_with("."));
    CHECK_FALSE(extent.formula.empty());
  }
}

TEST_CASE("a preference that declares no extents means the shipped ones", "[axioms][extents]") {
  AxiomFiles files = shipped_files();
  const AxiomSet shipped = AxiomSet::parse(files);
  files["preference.smt2"] = "(set-info :minimise (segment path))";
  const AxiomSet axioms = AxiomSet::parse(files);
  CHECK(axioms.is_shipped());
  CHECK(axioms.preference() == std::vector{Extent::segment, Extent::path});
  REQUIRE(axioms.extents().size() == shipped.extents().size());
  for (const ExtentDeclaration& extent : axioms.extents())
    CHECK(extent.terms == axioms.shipped_extent(extent.known.value()).terms);
  CHECK(AxiomSet::parse(without_preference(files)).preference() == shipped.preference());
}

TEST_CASE("an extent of one's own is known by its name", "[axioms][extents]") {
  const std::string end = "(set-info :extent (end ((q DState)) :where (ends q) (along q)))\n";
  const auto parse = [](const std::string& text) {
    AxiomFiles files = without_preference(shipped_files());
    files["own.smt2"] = text;
    return AxiomSet::parse(files);
  };
  const AxiomSet own = parse("(set-info :minimise (path end))\n" + end);
  CHECK(own.minimises_own());
  CHECK_FALSE(own.is_shipped());
  CHECK(own.preference_names() == std::vector<std::string>{"path", "end"});
  CHECK_FALSE(own.minimised().back().known);
  CHECK(own.minimised().back().line == 2);
  CHECK_THROWS_AS(own.preference(), std::logic_error);
  // Declared, not minimised.
  CHECK(parse(end).is_shipped());
  CHECK(parse(end).extents().size() == 4);
}

TEST_CASE("a shipped name may be declared as shipped, or otherwise", "[axioms][extents]") {
  const auto parse = [](const std::string& declaration) {
    AxiomFiles files = shipped_files();
    files["preference.smt2"] =
        "(set-info :extent " + declaration + ")\n(set-info :minimise (place path))\n";
    return AxiomSet::parse(files);
  };
  CHECK(parse("(path ((x DState)) (along x) (opp (along x)))").is_shipped());
  const AxiomSet other = parse("(path ((q DState)) (along q))");
  CHECK_FALSE(other.is_shipped());
  CHECK(other.preference_names() == std::vector<std::string>{"place", "path (own)"});
  CHECK(other.shipped_extent(Extent::path).terms.size() == 2);
}

TEST_CASE("without a word for the opposite direction, directed paths are counted",
          "[axioms][extents]") {
  AxiomFiles files = without_preference(with_axiom(shipped_files(), "turn_around"));
  std::string& text = files["topological.smt2"];
  const std::string declaration = "(declare-fun opp (DirectedPath) DirectedPath)";
  text.erase(text.find(declaration), declaration.size());
  const AxiomSet axioms = AxiomSet::parse(files);
  CHECK(axioms.shipped_extent(Extent::path).terms.size() == 1);
  CHECK(axioms.preference() == std::vector{Extent::path, Extent::place});
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
