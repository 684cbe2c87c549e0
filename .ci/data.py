"""Reads what the program writes as others would: tables with pandas, documents with jsonschema.

Fails if a table of a report, or one that a command writes, has a column in which numbers stand among words, or if a document
of a command does not have the form that `--json-schema` prints. Needs python3-pandas and python3-jsonschema.
`data.py REPORT PROGRAM`
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

import jsonschema
import pandas

TESTS = pathlib.Path(__file__).parent.parent / "models/tests/program"
# Seconds that a command may take: machines are busy.
PATIENCE = 1200


def lines(name):
    """The command lines that a test asks."""
    text = (TESTS / f"{name}.rs").read_text()
    found = re.findall(r'^    "(.*)",$', text.split("const LINES")[1].split("];")[0], re.M)
    assert len(found) > 10, name
    return [line.split() for line in found]


def ask(program, *words):
    done = subprocess.run([program, *words], capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 0 or "--json" in words, (words, done)
    return done.stdout


def is_number(cell):
    try:
        float(cell)
    except ValueError:
        return False
    return True


def numeric(path):
    """How many columns of numbers pandas finds; in all others there is no number."""
    table = pandas.read_csv(path)
    assert len(table) and not any(name.startswith("Unnamed") for name in table.columns), path
    count = 0
    for name in table.columns:
        column = table[name]
        if pandas.api.types.is_numeric_dtype(column):
            count += 1
            continue
        strangers = [cell for cell in column.dropna() if is_number(str(cell))]
        assert not strangers, f"{path}: {name}: {strangers[:3]} among words"
    assert count, f"{path} has no numbers"
    return count


def report(folder):
    files = sorted((folder / "data").glob("*.csv"))
    assert len(files) > 50, len(files)
    return len(files), sum(map(numeric, files))


def commands(program):
    """The commands that answer in JSON."""
    names = re.findall(r"^  ([a-z]+) ", ask(program, "--help").split("Commands:")[1].split("Options:")[0], re.M)
    return {name for name in names if name != "help" and "--json" in ask(program, name, "--help")}


def documents(program, out):
    schema = json.loads(ask(program, "--json-schema"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    asked = [[*line, "--quiet"] for line in lines("schema")]
    shares = "map belt-oscillator period --along v_dr=0.1..0.3:2 --and delta=1..3:2 --quiet --out".split()
    for share in ["1/2", "2/2"]:
        ask(program, *shares, out, "--shard", share)
    asked += [["status", out], ["merge", out]]
    for words in asked:
        document = json.loads(ask(program, *words, "--json"))
        faults = [fault.message for fault in validator.iter_errors(document)]
        assert not faults, (words, faults[:3])
    missing = commands(program) - {words[0] for words in asked}
    assert not missing, f"no document of {missing} was asked for"
    wrong = {**document, "schema": "one"}
    assert not validator.is_valid(wrong), "the schema takes anything"
    return len(asked)


def tables(program, out):
    count = 0
    for i, words in enumerate(lines("tables")):
        folder = pathlib.Path(out) / str(i)
        ask(program, *words, "--quiet", "--out", str(folder))
        count += len([numeric(path) for path in folder.glob("*.csv")])
    return count


def main():
    folder, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    print("{} tables of the report, {} columns of numbers".format(*report(folder)))
    with tempfile.TemporaryDirectory() as out:
        print(documents(program, out), "documents have the form that is printed")
    with tempfile.TemporaryDirectory() as out:
        print(tables(program, out), "tables of commands are read as numbers")


main()
