"""The rules of the house that a compiler does not check.

    house_rules.py RULE ROOT

RULE is layers, installed, sources, citations, hygiene, json or format. Prints one line a broken
rule, "file:line: found X; expected Y"; exits 1 if there is one, 77 if the rule cannot be checked here.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

# What each folder may include, its own headers aside: a folder, or of one some wings alone.
#                                                                             [ARCHITECTURE.md]
LAYERS = {
    "core": set(),
    "axioms": {"core"},
    "planarity": {"core"},
    "drawing": {"core", "planarity"},
    "engine": {"core", "axioms", "planarity"},
    "perception": {"core"},
    "metric": {"core"},
    "simulation": {"core"},
    "io": {"core", "axioms", "engine/ask", "engine/proof"},
}
LAYERS["mapping"] = set(LAYERS)
LAYERS["cli"] = set(LAYERS)
# The wings of a folder in a row; "" is the folder itself. Each may include itself and those before.
WINGS = {
    "engine": ["", "tree", "minimal", "ask", "proof", "ssh"],
    "io": ["", "json", "log", "grid", "picture"],
    "cli": ["text", "", "commands"],
}
# Folders that may use all of ours: nothing depends on them.
USERS = ["tests", "examples", "benchmarks"]

# Library, how its headers are named, the layers that may use it, those whose headers may.
EVERY = set(LAYERS)
LIBRARIES = [
    ("Z3", r"z3", {"axioms", "engine"}, {"axioms", "engine"}),  # none of them installed
    ("Boost", r"boost/", {"planarity", "drawing", "cli"}, set()),
    ("nlohmann-json", r"nlohmann/", {"io"}, set()),
    ("fmt", r"fmt/", {"io", "mapping", "cli"}, {"io", "mapping", "cli"}),
    ("zlib", r"zlib\.h", {"io", "cli"}, set()),
    ("liblzma", r"lzma\.h", {"io", "cli"}, set()),
    ("libpng", r"png\.h", {"io", "cli"}, set()),
    ("CLI11", r"CLI/", {"cli"}, {"cli"}),
    ("Eigen", r"Eigen/", {"core", "perception", "metric"}, {"core", "perception", "metric"}),
    ("Ceres", r"ceres/", {"metric"}, {"metric"}),
    ("Catch2", r"catch2/", set(), set()),
    ("RapidCheck", r"rapidcheck", set(), set()),
    ("the system", r"(sys/|(unistd|fcntl|signal|dlfcn|poll|spawn)\.h)", EVERY - {"core"}, set()),
    ("the standard library", r"[a-z_0-9]+$", EVERY, EVERY),
]

INSTALLED = re.compile(r"asterism_library\([^)]*?HEADERS\s([^)]*?)(?:SOURCES|LINKS|PRIVATE_LINKS|\))")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
COMMAND = re.compile(r"\b[A-Z]\w*Command\b")  # a type
LINK = re.compile(r"asterism::(\w+)")
CODE = {".cpp", ".hpp"}
TEXT = CODE | {".py", ".sh", ".smt2", ".lp", ".cmake", ".in", ".md"}  # not cases and corpora
CITATION = re.compile(r"\[([A-Z]+\d\d)[],]")
THEORY = re.compile(r"\[theory ([^]]*)")
ELSEWHERE = re.compile(r"\bDES" r"IGN\b")  # a page that is not in the repository
LONGEST_FILE = 450
PLANAR = re.compile(r"^\s+bool planar( =[^,]*)?;")  # a member
THEORIES = ["axioms/theory.hpp", "core/theory_record.hpp"]
EXTENT_TEXT = re.compile(r'[!=]= "(path|place|segment)"|"(path|place|segment)" [!=]=')
TYPE = re.compile(r"(?:struct|class|enum class|enum) (\w+)( final)?( : [^;]*)? {")  # of a namespace
JSON_KEY = re.compile(r'\\?"\w+\\?":')  # in a string, or in a raw one

# Spelt in parts, so that this file keeps its own rules.
MARKS = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK|WI" r"P)\b")
EMPTY_CHECKS = re.compile(r"\bSUC" r"CEED\s*\(|\b(CHECK|REQUIRE)\s*\(\s*true\s*\)")
HIDDEN_TESTS = re.compile(r'"[^"]*\[(\.|!hide|!may' r'fail|!should' r'fail)')


class CannotCheck(Exception):
    """A tool that a rule needs is not here."""


def files(root, folders, suffixes):
    for folder in folders:
        for file in sorted((root / folder).rglob("*")):
            if file.is_file() and file.suffix in suffixes and "__pycache__" not in file.parts:
                yield file


def cmake_lists(root):
    yield root / "CMakeLists.txt"
    for folder in [*LAYERS, *USERS]:
        yield from sorted((root / folder).rglob("CMakeLists.txt"))


def numbered_lines(file):
    return enumerate(file.read_text(encoding="utf-8").splitlines(), start=1)


def complaint(root, file, line, found, expected):
    return f"{file.relative_to(root)}:{line}: found {found}; expected {expected}"


def layers(root):
    """Every include and every link of a layer is of a folder or library its column allows."""
    for layer, below in LAYERS.items():
        allowed = below | {layer}
        for file in files(root, [layer], CODE):
            for number, line in numbered_lines(file):
                if match := INCLUDE.match(line):
                    quote, name = match.groups()
                    expected = refused_include(layer, file.suffix == ".hpp", quote, name, allowed)
                    expected = expected or refused_wing(root, file, name)
                    if expected:
                        yield complaint(root, file, number, f"include of {name}", expected)
                elif layer != "cli" and (match := COMMAND.search(line)):
                    yield complaint(root, file, number, match[0], "no command below cli")
        for file in (root / layer).rglob("CMakeLists.txt"):
            for number, line in numbered_lines(file):
                for name in LINK.findall(line.split("#")[0]):
                    if name not in {folder.split("/")[0] for folder in allowed}:
                        found = f"asterism::{name}"
                        yield complaint(root, file, number, found, one_of(allowed))
    for file in files(root, USERS, CODE):
        for number, line in numbered_lines(file):
            match = INCLUDE.match(line)
            if match and match[2].startswith("catch2/") and not file.is_relative_to(root / "tests"):
                found = f"include of {match[2]}"
                yield complaint(root, file, number, found, "Catch2 in tests alone")


def refused_include(layer, is_header, quote, name, allowed):
    """What was expected instead of this include, or None if it is allowed."""
    if quote == '"':
        is_allowed = any(name.startswith(folder + "/") for folder in allowed)
        return None if is_allowed else one_of(allowed)
    for library, pattern, users, header_users in LIBRARIES:
        if re.match(pattern, name):
            if layer not in users:
                return f"{library} in {names(users)} alone"
            if is_header and layer not in header_users:
                return f"{library} in no header here"
            return None
    return "a library that ARCHITECTURE.md names"


def installed(root):
    """Every header that is installed includes, of ours, only such as are, and shows no Z3."""
    headers = {
        file.parent / name
        for file in cmake_lists(root)
        for names_listed in INSTALLED.findall(file.read_text())
        for name in names_listed.split()
    }
    for header in sorted(headers):
        for number, line in numbered_lines(header):
            match = INCLUDE.match(line)
            if not match:
                continue
            quote, name = match.groups()
            found = f"include of {name}"
            if quote == '"' and root / name not in headers:
                yield complaint(root, header, number, found, "a header that is installed")
            if quote == "<" and name.startswith("z3"):
                yield complaint(root, header, number, found, "Z3 in no header that is installed")


def refused_wing(root, file, name):
    """What was expected instead of this include of the same folder, or None if it is allowed."""
    folder, _, place = str(file.parent.relative_to(root)).partition("/")
    included_folder, _, included = name.rpartition("/")[0].partition("/")
    if folder not in WINGS or included_folder != folder:
        return None
    row = WINGS[folder]
    if place not in row:
        return f"a wing of {folder}: {', '.join(filter(None, row))}"
    allowed = row[: row.index(place) + 1]
    if included in allowed:
        return None
    return f"something of {', '.join(f'{folder}/{name}'.rstrip('/') for name in allowed)}"


def one_of(folders):
    return f"something of {names(folders)}"


def names(folders):
    order = list(LAYERS)
    return ", ".join(sorted(folders, key=lambda name: order.index(name.split("/")[0]))) or "tests"


def sources(root):
    """Every source file is listed in a CMakeLists.txt beside or above it; one that tests share, in
    any of theirs."""
    for file in files(root, [*LAYERS, *USERS], CODE):
        folder = file.relative_to(root).parts[0]
        layered = folder in LAYERS and folder != "cli"  # the program's headers are nobody else's
        if not layered and file.suffix == ".hpp":
            continue
        lists = [d / "CMakeLists.txt" for d in file.parents if d.is_relative_to(root)]
        lists = [file for file in lists if file.exists()]
        if file.parent.name == "support":
            lists += sorted((root / folder).rglob("CMakeLists.txt"))
        if not any(mentions(text, file, whole_name=layered) for text in lists):
            found = f"no mention of {file.relative_to(lists[0].parent)}"
            yield complaint(root, lists[0], 1, found, "every source file listed")


def mentions(cmake_list, file, whole_name):
    shared = not file.is_relative_to(cmake_list.parent)
    name = f"../support/{file.name}" if shared else str(file.relative_to(cmake_list.parent))
    name = name if whole_name else name.removesuffix(file.suffix)
    return re.search(rf"((?<![\w/.])|(?<=}}/)){re.escape(name)}(?!\w)", cmake_list.read_text())


def citations(root):
    """Every key cited is resolved in docs/references.md, every section in docs/theory.md."""
    references = root / "docs/references.md"
    known = set(re.findall(r"\*\*\[(\w+)\]\*\*", references.read_text(encoding="utf-8")))
    theory = root / "docs/theory.md"
    sections = set(re.findall(r"^## (\d+)\.", theory.read_text(encoding="utf-8"), re.MULTILINE))
    for file in [*sorted(root.glob("*.md")), *files(root, [*LAYERS, *USERS, "docs"], TEXT)]:
        for number, line in numbered_lines(file):
            for key in CITATION.findall(line):
                if key not in known:
                    yield complaint(root, file, number, f"[{key}]", "a key of docs/references.md")
            if found := ELSEWHERE.search(line):
                yield complaint(root, file, number, found[0], "a section of docs/theory.md")
            for cited in THEORY.findall(line):
                for section in re.findall(r"§(\d+)", cited):
                    if section not in sections:
                        expected = "a section of docs/theory.md"
                        yield complaint(root, file, number, f"§{section}", expected)


def hygiene(root):
    """Short files without tabs, marks of unfinished work, empty checks or hidden tests."""
    folders = [*LAYERS, *USERS, "docs", "cmake", "scripts", ".ci"]
    texts = [*sorted(root.glob("*.md")), *files(root, folders, TEXT)]
    texts += [*files(root, ["scripts", ".ci"], {""}), *cmake_lists(root)]
    for file in texts:
        lines = list(numbered_lines(file))
        if len(lines) > LONGEST_FILE:
            expected = f"at most {LONGEST_FILE}, or a second file"
            yield complaint(root, file, len(lines), f"{len(lines)} lines", expected)
        for number, line in lines:
            if "\t" in line:
                yield complaint(root, file, number, "a tab", "spaces")
            if line != line.rstrip() and file.suffix != ".md":
                yield complaint(root, file, number, "space at the end", "none")
            if mark := MARKS.search(line):
                yield complaint(root, file, number, mark[0], "finished work")
            if file.suffix in CODE:
                if EMPTY_CHECKS.search(line):
                    yield complaint(root, file, number, "a check of nothing", "a check")
                if "TEST_CASE" in line and HIDDEN_TESTS.search(line):
                    yield complaint(root, file, number, "a hidden test", "tests that run and count")


def json_by_hand(root):
    """No JSON is written key by key, but by the writer in io/json."""
    for file in files(root, [*LAYERS, "examples", "benchmarks"], CODE):
        for number, line in numbered_lines(file):
            if key := JSON_KEY.search(line.split("//")[0]):
                yield complaint(root, file, number, f"the key {key[0]}", "JsonWriter of io/json")


def types(root):
    """What is asked of maps is passed as a theory, extents are no strings, and one name is one type:
    of two, a linker keeps whichever functions it sees first."""
    seen = {}
    for file in files(root, [*LAYERS, "examples", "benchmarks"], CODE):
        for number, line in numbered_lines(file):
            if PLANAR.match(line) and str(file.relative_to(root)) not in THEORIES:
                yield complaint(root, file, number, "a member planar", "a Theory")
            if EXTENT_TEXT.search(line):
                yield complaint(root, file, number, "an extent as text", "an Extent")
        for number, name in shared_types(file):
            if file.relative_to(root).parts[0] in LAYERS and name in seen:
                yield complaint(root, file, number, f"{name} again", f"one type: {seen[name]}")
            seen[name] = file.relative_to(root)


def shared_types(file):
    """Line and name of each type that a file defines in a namespace that has a name."""
    is_named = True
    for number, line in numbered_lines(file):
        if line.startswith("namespace") or line.startswith("}  // namespace"):
            is_named = line != "namespace {"
        if is_named and (match := TYPE.match(line)):
            yield number, match[1]


def formatting(root):
    """clang-format 14 would change nothing."""
    tool = next(filter(is_version_14, ["clang-format-14", "clang-format"]), None)
    if not tool:
        raise CannotCheck("clang-format: found no version 14; expected one")
    for file in files(root, [*LAYERS, *USERS], CODE):
        text = file.read_text(encoding="utf-8")
        wanted = output([tool, f"--assume-filename={file}"], text)
        if text != wanted:
            pairs = zip(text.splitlines() + [""], wanted.splitlines() + [""])
            line = next((n for n, (a, b) in enumerate(pairs, start=1) if a != b), 1)
            yield complaint(root, file, line, "another layout", "clang-format's")


def is_version_14(tool):
    return shutil.which(tool) is not None and " 14." in output([tool, "--version"])


def output(command, text=""):
    return subprocess.run(command, input=text, stdout=subprocess.PIPE, text=True, check=True).stdout


RULES = {
    "layers": layers,
    "installed": installed,
    "sources": sources,
    "citations": citations,
    "hygiene": hygiene,
    "json": json_by_hand,
    "types": types,
    "format": formatting,
}


def main():
    rule, root = sys.argv[1:]
    try:
        complaints = list(RULES[rule](Path(root)))
    except CannotCheck as reason:
        print(reason)
        sys.exit(77)
    print("\n".join(complaints) or f"{rule}: nothing to say")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
