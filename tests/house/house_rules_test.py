"""Each rule of the house can fail: a small tree that keeps all rules, broken once a case."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import house_rules  # noqa: E402

TREE = {
    "CMakeLists.txt": "project(small)\n",
    "core/CMakeLists.txt": "asterism_library(core HEADERS star.hpp SOURCES star.cpp)\n",
    "core/star.hpp": "#pragma once\n\n#include <vector>\n",
    "core/star.cpp": '#include "core/star.hpp"\n',
    "axioms/CMakeLists.txt": "asterism_library(axioms\n  HEADERS reader.hpp\n"
    "  SOURCES bench.hpp\n  LINKS asterism::core)\n",
    "axioms/reader.hpp": '#pragma once\n\n#include "core/star.hpp"\n',
    "axioms/bench.hpp": '#pragma once\n\n#include <z3++.h>\n\n#include "axioms/reader.hpp"\n',
    "docs/references.md": "- **[RK04]** Remolina, Kuipers.\n",
    "docs/theory.md": "# Theory\n\n## 1. Words\n",
    "tests/CMakeLists.txt": "asterism_test(core SOURCES core/star_test.cpp)\n",
    "tests/core/star_test.cpp": '#include <catch2/catch.hpp>\n\n#include "core/star.hpp"\n',
}

# rule, file, its new text, what the complaint says
BROKEN = [
    ("layers", "core/star.cpp", '#include "axioms/reader.hpp"\n', "core/star.cpp:1: found include"),
    ("layers", "core/star.cpp", '#include "star.hpp"\n', "expected something of core"),
    ("layers", "core/star.cpp", "#include <z3++.h>\n", "expected Z3 in axioms, engine alone"),
    ("layers", "core/star.cpp", "# include  <boost/graph/graph.hpp>\n", "Boost in planarity"),
    ("layers", "core/star.cpp", "#include <spdlog/spdlog.h>\n", "a library that ARCHITECTURE.md"),
    ("layers", "core/star.cpp", "#include <catch2/catch.hpp>\n", "Catch2 in tests alone"),
    ("layers", "io/trace.hpp", "#include <nlohmann/json.hpp>\n", "nlohmann-json in no header"),
    ("layers", "cli/main.hpp", "#include <z3++.h>\n", "Z3 in axioms, engine alone"),
    ("layers", "planarity/a.hpp", "#include <boost/graph/graph.hpp>\n", "Boost in no header here"),
    ("layers", "examples/a.cpp", "#include <catch2/catch.hpp>\n", "Catch2 in tests alone"),
    ("layers", "engine/tree/a.cpp", '#include "engine/ask/a.hpp"\n', "of engine, engine/tree"),
    ("layers", "engine/a.cpp", '#include "engine/tree/a.hpp"\n', "expected something of engine"),
    ("layers", "engine/attic/a.cpp", '#include "engine/a.hpp"\n', "expected a wing of engine"),
    ("layers", "io/json/a.cpp", '#include "io/picture/a.hpp"\n', "something of io, io/json"),
    ("layers", "cli/text/a.cpp", '#include "cli/commands/a.hpp"\n', "something of cli/text"),
    ("layers", "mapping/a.cpp", '#include "cli/a.hpp"\n', "mapping/a.cpp:1: found include"),
    ("layers", "mapping/a.hpp", "int map(const MapCommand&);\n", "found MapCommand"),
    ("layers", "core/CMakeLists.txt", "link(asterism::axioms)\n", "found asterism::axioms"),
    ("installed", "axioms/reader.hpp", "#include <z3++.h>\n", "reader.hpp:1: found include of z3++"),
    ("installed", "axioms/reader.hpp", '#include "axioms/bench.hpp"\n', "a header that is installed"),
    ("sources", "core/grid.cpp", "", "core/CMakeLists.txt:1: found no mention of grid.cpp"),
    ("sources", "core/tar.hpp", "", "found no mention of tar.hpp"),
    ("sources", "tests/core/grid_test.cpp", "", "found no mention of core/grid_test.cpp"),
    ("citations", "core/star.cpp", "// [RK04]\n// [XY" "99]\n", "star.cpp:2: found [XY" "99]"),
    ("citations", "core/star.cpp", "// [theory §1]\n// [theory §1, §2]", "star.cpp:2: found §2"),
    ("citations", "core/star.cpp", "// [DES" "IGN §1]\n", "star.cpp:1: found DES" "IGN"),
    ("hygiene", "core/star.cpp", "\tint i;\n", "core/star.cpp:1: found a tab"),
    ("hygiene", "core/star.cpp", "int i; \n", "found space at the end"),
    ("hygiene", "core/star.cpp", "// FIX" "ME\n", "expected finished work"),
    ("hygiene", "core/star.cpp", "int i;\n" * 451, "found 451 lines"),
    ("hygiene", "tests/core/star_test.cpp", "CHECK(true" ");\n", "found a check of nothing"),
    ("hygiene", "tests/core/star_test.cpp", 'TEST_CASE("a", "[.' 'slow]") {}\n', "a hidden test"),
    ("hygiene", "scripts/demo", "# TO" "DO\n", "scripts/demo:1"),
    ("json", "io/maps.cpp", r'out << "{ \"star\": ";', r'the key \"star\":; expected JsonWriter'),
    ("json", "cli/main.cpp", 'out << R"({"star": 1})";', 'main.cpp:1: found the key "star":'),
    ("types", "io/a.hpp", "struct Page {\n  bool planar;\n};\n", "io/a.hpp:2: found a member planar"),
    ("types", "io/a.cpp", 'return name == "place";\n', "io/a.cpp:1: found an extent as text"),
    ("types", "io/a.hpp", "class A {};\n\nclass A {\n};\n", "io/a.hpp:3: found A again; expected one"),
    ("format", "core/star.cpp", "int  i ;\n", "core/star.cpp:1: found another layout"),
]


class HouseRulesTest(unittest.TestCase):
    def complaints(self, rule, changes):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (TREE | changes).items():
                file = Path(folder, name)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            try:
                return list(house_rules.RULES[rule](Path(folder)))
            except house_rules.CannotCheck as reason:
                self.skipTest(str(reason))

    def test_a_tree_that_keeps_the_rules_passes(self):
        for rule in house_rules.RULES:
            with self.subTest(rule):
                self.assertEqual(self.complaints(rule, {}), [])

    def test_each_broken_rule_is_named_with_file_and_line(self):
        for rule, file, text, expected in BROKEN:
            with self.subTest(rule=rule, file=file, text=text[:40]):
                found = self.complaints(rule, {file: text})
                self.assertGreaterEqual(len(found), 1)
                self.assertIn(expected, found[0])


if __name__ == "__main__":
    unittest.main()
