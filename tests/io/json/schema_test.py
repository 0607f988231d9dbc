"""Holds docs/<kind>.schema.json against the corpus that the reader is held against.

usage: schema_test.py SOURCE_DIR KIND, KIND being trace, maps, expect, checkpoint, or answers (which
nothing reads)

bad.tsv says of each bad file what a schema can make of it: `refuses`, `accepts` (what is wrong is
beyond a schema), or `no-json` (there is nothing to judge). Exit code 77: jsonschema is missing.
"""

import csv
import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)


def load(file):
    def refuse(constant):
        raise ValueError(constant)

    return json.loads(file.read_bytes().decode("utf-8"), parse_constant=refuse)


def judge(validator, file):
    try:
        content = load(file)
    except ValueError:
        return "no-json"
    return "accepts" if validator.is_valid(content) else "refuses"


def main(source, kind):
    schema = load(source / "docs" / f"{kind}.schema.json")
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    corpus = source / "tests" / "corpus" / kind

    with open(corpus / "bad.tsv", encoding="utf-8", newline="") as listing:
        rows = list(csv.DictReader(listing, delimiter="\t", quoting=csv.QUOTE_NONE))
    expected = {corpus / "bad" / row["file"]: row["schema"] for row in rows}
    for folder in (corpus / "good", source / "tests" / "traces"):
        expected |= {file: "accepts" for file in folder.glob(f"*.{kind}.json")}

    wrong = 0
    for file, verdict in sorted(expected.items()):
        if (found := judge(validator, file)) != verdict:
            print(f"{file}: found {found}; expected {verdict}")
            wrong += 1
    print(f"{kind}: {len(expected)} files, {wrong} judged otherwise than expected")
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), sys.argv[2]))
