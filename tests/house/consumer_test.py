"""Builds a program against the installed package, runs it and compares what it prints.

With --without PACKAGE these cannot be found; then the component --refused must not be either."""

import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        print(done.stdout)
        sys.exit(f"{command[0]}: found exit code {done.returncode}; expected 0")
    return done.stdout


def succeeds(*command):
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return done.returncode == 0


def program_text(file):
    """The file, or of a Markdown file the first block of C++."""
    text = file.read_text(encoding="utf-8")
    if file.suffix != ".md":
        return text
    block = re.search(r"^```cpp\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    if not block:
        sys.exit(f"{file}: found no block of C++; expected one")
    return block[1]


def main():
    parser = argparse.ArgumentParser()
    for path in ["--prefix", "--project", "--scratch", "--program", "--expected"]:
        parser.add_argument(path, type=Path, required=True)
    for text in ["--cmake", "--compiler", "--components", "--links"]:
        parser.add_argument(text, required=True)
    parser.add_argument("--without", default="")
    parser.add_argument("--refused")
    parser.add_argument("arguments", nargs="*")
    options = parser.parse_args()

    shutil.rmtree(options.scratch, ignore_errors=True)
    options.scratch.mkdir(parents=True)
    program = options.scratch / "main.cpp"
    program.write_text(program_text(options.program), encoding="utf-8")

    build = options.scratch / "build"
    configure = [
        options.cmake, "-G", "Ninja", "-S", str(options.project),
        f"-DCMAKE_CXX_COMPILER={options.compiler}", f"-DCMAKE_PREFIX_PATH={options.prefix}",
        f"-DPROGRAM={program}", f"-DLINKS={options.links}",
        *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=TRUE"
          for package in options.without.split(";") if package),
    ]  # fmt: skip
    run(*configure, "-B", str(build), f"-DCOMPONENTS={options.components}")
    if options.refused:
        other = [*configure, "-B", str(options.scratch / "refused")]
        if succeeds(*other, f"-DCOMPONENTS={options.refused}"):
            sys.exit(f"find_package: found {options.refused}; expected it to need what is not here")
    run(options.cmake, "--build", str(build))

    printed = run(str(build / "consumer"), *options.arguments)
    if printed != options.expected.read_text(encoding="utf-8"):
        sys.exit(f"consumer: found\n{printed}; expected the text of {options.expected}")


if __name__ == "__main__":
    main()
