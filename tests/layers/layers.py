"""Fails when a file of lib/percal includes a layer that it may not see. The order is the path of data."""
import pathlib
import re
import sys

MAY_SEE = {
    "base": [],
    "math": ["base"],
    "units": ["base"],
    "text": ["base", "units"],
    "plot": ["base", "text"],
    "page": ["base", "units", "text", "plot"],
    "material": ["base", "math", "units"],
    "mesh": ["base", "math"],
    "scene": ["base", "math", "units", "text", "material"],
    "scaling": ["base", "math", "units", "text", "material", "plot", "page", "scene"],
    "problem": ["base", "math", "units", "text", "material", "mesh", "scene"],
    "impact": ["base", "math", "material", "mesh", "problem"],
    "solid": ["base", "math", "material", "mesh", "problem", "impact"],
    "observe": ["base", "math", "units", "text", "plot", "scene", "problem", "impact", "page"],
    "store": ["base"],
    "estimate": ["base", "math"],
    "card": ["base", "units", "text", "material"],
    "fit": ["base", "math", "units", "text", "material", "estimate", "card", "plot", "page"],
    "invert": ["base", "math"],
    "campaign": ["base", "math", "units", "page", "scene", "problem", "impact", "solid", "observe", "store", "invert"],
    "study": ["base", "math", "units", "text", "plot", "mesh", "scene", "problem", "impact", "observe", "store", "campaign", "page"],
    "identify": ["base", "math", "units", "text", "material", "scaling", "scene", "problem", "impact", "observe", "store", "invert", "card", "campaign", "atlas", "plot", "page"],
    "cluster": ["base", "math", "text", "problem", "impact", "observe", "store", "campaign"],
    "sweep": ["base", "math", "units", "text", "scaling", "scene", "problem", "impact", "observe", "store", "campaign", "plot", "page"],
    "atlas": ["base", "math", "units", "text", "scene", "problem", "observe", "store", "invert", "campaign"],
    "predict": ["base", "math", "units", "text", "scene", "problem", "observe", "invert", "campaign", "plot", "page"],
    "powder": ["base", "math", "units", "text", "scene", "invert", "predict", "plot", "page"],
    "one_depth": ["base", "math", "units", "text", "scene", "problem", "impact", "observe", "invert", "campaign", "predict", "atlas", "plot", "page"],
    "calibrate": ["base", "math", "units", "text", "material", "scaling", "scene", "problem", "impact", "observe", "store", "estimate", "fit", "invert", "card", "campaign", "predict", "atlas", "plot", "page"],
}

# Rooms of a layer, in their order: a file includes rooms up to its own; one that lies beside them, none.
ROOMS = {
    "fit": ["points", "shape", "read", "search", "interval", "relaxation", "page"],
    "impact": ["kernel", "target", "particle", "march"],
    "solid": ["kernel", "target", "particle", "march"],
}


def cycle(table):
    """The layers that cannot be ordered; empty when the table is sound."""
    todo = {layer: set(sees) for layer, sees in table.items()}
    while True:
        free = [layer for layer, sees in todo.items() if not sees & todo.keys()]
        if not free:
            return sorted(todo)
        for layer in free:
            del todo[layer]


def rooms_up_to(parts):
    rooms = ROOMS[parts[0]]
    return rooms[:rooms.index(parts[1]) + 1] if parts[1] in rooms else []


def violations(root):
    for file in sorted(pathlib.Path(root).rglob("*.[ch]pp")):
        parts = file.relative_to(root).parts
        layer = parts[0] if len(parts) > 1 else file.stem  # LAYER.hpp includes the headers of its own layer
        if layer not in MAY_SEE:
            yield f"{file}: the table has no layer {layer}"
            continue
        for number, line in enumerate(file.read_text().splitlines(), 1):
            found = re.match(r'\s*#\s*include\s+["<]percal/([a-z_]+)[/.]', line)
            if found and found[1] != layer and (len(parts) == 1 or found[1] not in MAY_SEE[layer]):
                yield f"{file}:{number}: {layer} may not include {found[1]}"
            room = re.match(rf'\s*#\s*include\s+"percal/{layer}/([a-z_]+)/', line)
            if room and layer in ROOMS and len(parts) > 1 and room[1] not in rooms_up_to(parts):
                yield f"{file}:{number}: may not include the room {layer}/{room[1]}"


def without_header(root):
    for layer in MAY_SEE:
        if (pathlib.Path(root) / layer).is_dir() and not (pathlib.Path(root) / f"{layer}.hpp").is_file():
            yield f"{root}: layer {layer} has no {layer}.hpp"


def main(root):
    faults = list(violations(root)) + list(without_header(root))
    unordered = cycle(MAY_SEE)
    if unordered:
        faults.append("the table has a cycle through " + ", ".join(unordered))
    print("\n".join(faults) or "layers hold")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
