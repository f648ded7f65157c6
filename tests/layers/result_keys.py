"""Fails when a key of a result is read elsewhere than in the layer that writes it. What every result has is written and read in page/;
the comparison looks at any result and reads by general rules; card/ reads the block that it writes itself."""
import pathlib
import re
import sys

# Keys that every command may write and page/ reads: sentences, what was left out, the ends of an interval.
SHARED = {"findings", "cost", "left_out", "what", "why", "level", "seed", "low", "high", "low_open", "high_open", "job", "scene", "toml"}
COMPARISON = re.compile(r"page/comparison[a-z_]*\.cpp$")

READ = re.compile(r'\b(?:at|maybe|list|number|number_or|text|yes|value_words|interval_words|with_unit)\((?:[^()"]|\([^()]*\))*,\s*"([A-Za-z_0-9]+)"')
WRITTEN = re.compile(r'\{\s*"([A-Za-z_0-9]+)"\s*,|\[\s*"([A-Za-z_0-9]+)"\s*\]\s*=|(?:with_unit|key_of)\("([A-Za-z_0-9]+)"')


def layer_of(root, file):
    return file.relative_to(root).parts[0]


def reads_results(source):
    return "percal/page/result.hpp" in source or "percal/page/sections.hpp" in source or "page/page.hpp" in source


def main(root):
    root = pathlib.Path(root)
    sources = {file: file.read_text() for file in sorted(root.rglob("*.[ch]pp")) if file.parent != root}
    written = {}
    for file, source in sources.items():
        for match in WRITTEN.finditer(source):
            written.setdefault(layer_of(root, file), set()).add(next(filter(None, match.groups())))
    faults, looked_at = [], 0
    for file, source in sources.items():
        if not reads_results(source) or COMPARISON.search(str(file)):
            continue
        layer = layer_of(root, file)
        known = written.get(layer, set()) | written.get("page", set()) | SHARED
        for number, line in enumerate(source.splitlines(), 1):
            for key in READ.findall(line):
                looked_at += 1
                if key not in known and not any(key + unit in known for unit in ("_Pa", "_m")):
                    faults.append(f"{file}:{number}: the key \"{key}\" is not written in {layer}/")
    if looked_at < 100:
        faults.append(f"only {looked_at} keys were looked at: does this test still know how keys are read?")
    print("\n".join(faults) or f"{looked_at} keys are read where they are written")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
