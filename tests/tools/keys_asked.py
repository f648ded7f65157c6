"""Fails where a reader of TOML files asks for a key that the reference of keys does not have: a sample document is missing then.

keys_asked.py PROGRAM LIB: every text literal that a reader hands to a getter is looked for in `percal keys KIND --json`."""
import json
import pathlib
import re
import subprocess
import sys

READERS = ["scene/*_toml.cpp", "scaling/system.cpp", "scaling/system_toml.cpp", "scaling/scale_job.cpp",
           "identify/read_job.cpp", "calibrate/job/*.cpp", "text/job_table.cpp"]
WRITERS = {"scene_to_toml.cpp"}
GETTERS = ("quantity|quantities|quantity_pairs|quantity_triples|optional_quantity|number|numbers|optional_number|integer|optional_integer|flag|text"
           "|texts|optional_text|word|table|tables|optional_table|path|optional_path|knows|has|is_array|is_text")
# Functions of the readers that hand a key on: the key is their first or second argument.
HELPERS = ("share|choice|angle|column_of|column_index|share_from|optional_share_from|number_from|values_of_rows|one_of|one_of_rows|layer_size|lengths"
           "|in_own_unit|filter_from|rows_meeting|check_exponent")
LITERALS = [re.compile(rf'(?:\.|->)(?:{GETTERS})\(\s*"([^"]+)"'),
            re.compile(rf'\b(?:{HELPERS})\((?:\*?\w+,\s*)?"([^"]+)"'),
            re.compile(r'\{"([a-z_]+)",\s*(?:dimension::|"[^"]*",\s*"[^"]*",\s*dimension::|"[^"]*",\s*"[^"]*",\s*Dimension)')]
# Cells of CSV tables, the columns of vertices and of curves; the older spelling of hypotheses; what older scenes have.
NOT_KEYS = {"x", "y", "z", "readings", "contact_stiffness"}


def literals(root):
    for pattern in READERS:
        for file in sorted(pathlib.Path(root).glob(pattern)):
            if file.name in WRITERS:
                continue
            for literal in LITERALS:
                for found in literal.finditer(file.read_text()):
                    yield found[1], file.name


def recorded(program):
    names = set()
    for kind in ["scene", "scale", "identify", "calibrate"]:
        output = subprocess.run([program, "keys", kind, "--json"], check=True, capture_output=True, text=True).stdout
        for key in json.loads(output)["keys"]:
            names.add(key["key"].split(".")[-1].removesuffix("[]"))
    return names


def main(program, root):
    names, asked = recorded(program), set(literals(root))
    missing = sorted({f"{file}: {key}" for key, file in asked if key not in names | NOT_KEYS})
    if len(asked) < 200:
        missing.append(f"only {len(asked)} keys found in the readers: has their way of asking changed?")
    print("\n".join(missing) or f"{len(asked)} keys asked for, all in the reference")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
