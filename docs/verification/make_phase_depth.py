"""Writes docs/verification/phase_depth.md from runs of the program (five minutes of processor time):

    python3 docs/verification/make_phase_depth.py build/release/percal
"""
from five_scenes import SCENES, scene
from harness import command_line, mesh, percent, percent_off, processor, replicates, table, write_page

LENGTH = 0.5              # over which erosion is judged, radii
MESHES = {"S": (6, 8, 10), "M": (6, 8, 10), "P": (6, 8, 10), "F": (6, 8), "U": (6, 8)}
WITHIN = 2                # per cent


def rows_of(program, name, *numbers, count):
    text = scene(*numbers, erosion=f'length = "{LENGTH} m"')
    for n in MESHES[name[0]]:
        coarse = program.impact(text, *mesh(n), *replicates(count))
        line = program.ask("impact", program.scene(text), "--threads", "1", *program.kept(), *mesh(n), *replicates(count), "--extrapolate")["extrapolation"]
        if line is None:
            yield [name, n, f"{1 / (n * LENGTH):.2f}", coarse.depth_words(1), "-", "-", "-", f"{count * coarse.cpu():.2g}"]
            continue
        error = 1.96 * coarse.error / line["depth_m"]
        off = coarse.depth / line["depth_m"] - 1
        yield [name, n, f"{1 / (n * LENGTH):.2f}", coarse.depth_words(1), f"{line['depth_m']:.2f} ± {line['standard_error_m']:.2f}", percent_off(coarse.depth, line["depth_m"]),
               percent((off ** 2 + error ** 2) ** 0.5), f"{count * coarse.cpu():.2g}"]


def page(program):
    rows = [row for name, *numbers, count in SCENES for row in rows_of(program, name, *numbers, count=count)]
    return f"""# What a depth within {WITHIN} % costs

Made by make_phase_depth.py. The five shots of [friction.md](friction.md) without friction, erosion judged over {LENGTH} radii; means of five replicates, of three for F and U, over the phase of the mesh, with the standard error of the
mean, against the depth at h = 0 from this mesh and one with twice as many elements per radius (`--extrapolate`). Depths in radii. The error is the root of the squares of the distance and of 1.96 standard errors; CPU seconds
of all replicates on this mesh, {processor()}, one thread.

{table(["scene", "elements per radius", "h/l", "depth", "at h = 0", "off", "error", "CPU, s"], rows)}

{program.machine()}.
"""


if __name__ == "__main__":
    write_page(command_line(__doc__, "phase_depth.md"), page)
