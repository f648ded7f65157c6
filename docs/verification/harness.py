"""What the generators of these pages share: the command line, running percal and reading what it says of an impact, published CSV files, numbers in words,
tables of Markdown, and drawing by gnuplot."""
import argparse
import csv
import enum
import itertools
import json
import math
import os
import pathlib
import platform
import shutil
import statistics
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

PAGES = pathlib.Path(__file__).resolve().parent
ROOT = PAGES.parent.parent
THESIS = ROOT / "data" / "guha2009"


# The command line.

class Store(enum.Enum):
    """Where evaluations are kept that no --store names a file for."""
    PERCALS = "percal's own"
    OF_PAGE = "a new one for the page"
    OF_RUN = "a new one for every run, so that each is timed here"


def command_line(doc, page, *inputs, store=Store.OF_RUN, jobs=None):
    """The parser of a generator of `page`. Its inputs are percal, unless others are named; `jobs`: how many scenes may run side by side."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in inputs or ("program",):
        parser.add_argument(name)
    parser.add_argument("--page", "--out", type=pathlib.Path, default=PAGES / page, help=f"file to write (default: {page} here)")
    parser.set_defaults(store=store, jobs=1)
    if not inputs:
        parser.add_argument("--store", type=os.path.abspath, default=store, help=f"file that keeps evaluations (default: {store.value})")
    if jobs:
        parser.add_argument("--jobs", type=int, default=jobs, help=f"scenes side by side (default: {jobs})")
    return parser


def write_page(parser, page):
    """Writes the text that `page` makes of percal's runs."""
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        options.page.write_text(page(Program(options, pathlib.Path(folder))))


def figures_of(page):
    """The folder that the page's links to ../figures mean."""
    folder = page.resolve().parent.parent / "figures"
    folder.mkdir(exist_ok=True)
    return folder


# Running programs.

class Failed(SystemExit):
    """Ends a generator with what the program said, unless it looks."""


def output(command, folder=None, environment=None, accepted=(0,)):
    """What a program prints."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, cwd=folder, env={**os.environ, **(environment or {})})
    if done.returncode not in accepted:
        raise Failed(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr}")
    return done.stdout


def at_level(level):
    """The environment that asks for an instruction level; None: the processor's own."""
    return {"PERCAL_ISA": level} if level else {}


def located(program):
    path = shutil.which(program)
    if not path:
        raise SystemExit(f"no program {program}")
    return pathlib.Path(path).resolve()


class Program:
    """percal, run in a folder that goes with the generator, so that nothing else is left behind."""

    def __init__(self, options, folder):
        self.path, self.options, self.folder = located(options.program), options, folder
        self.pool, self.count = ThreadPoolExecutor(options.jobs), itertools.count(1)
        self.level = self.version = ""
        self.cpu = 0.0  # s, of all impacts

    def run(self, *words, level=None, accepted=(0,)):
        return output([self.path, *words], self.folder, at_level(level), accepted)

    def ask(self, *words, level=None, accepted=(0, 3)):
        """What a command answers in JSON. Exit code 3: an outcome to look at, which the answer states."""
        answer = json.loads(self.run(*words, "--json", level=level, accepted=accepted))
        self.level, self.version = (answer.get("cost") or {}).get("isa") or self.level, answer.get("percal", self.version)
        return answer

    def kept(self):
        """The option that names the store."""
        if self.options.store is Store.PERCALS:
            return []
        own = {Store.OF_PAGE: "page.store", Store.OF_RUN: f"run{next(self.count)}.store"}
        return ["--store", self.folder / own.get(self.options.store, self.options.store)]

    def scene(self, text, name=None):
        file = self.folder / f"{name or f'scene{next(self.count)}'}.toml"
        file.write_text(text)
        return file

    def impact(self, text, *options, level=None):
        try:
            answer = self.ask("impact", self.scene(text), "--threads", "1", *self.kept(), *options, level=level)
        except Failed as failed:
            raise Failed(f"{failed}\n{text}") from None
        result = impact_of(answer)
        self.cpu += sum(run.cpu for run in result.runs)
        return result

    def impacts(self, scenes, *options):
        return list(self.pool.map(lambda text: self.impact(text, *options), scenes))

    def machine(self):
        """The program and the machine of the answers so far."""
        return f"percal {self.version}, {self.level}, {processor()}"


def replicates(n):
    return "--replicates", str(n)


def mesh(n):
    return "--elements-per-radius", str(n)


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor() or "unknown"


# What percal says of an impact. Its keys stand in impact_of and run_of alone; docs/formats/impact.md says what they mean.

@dataclass(frozen=True)
class Run:
    outcome: str
    depth: float | None  # m
    cpu: float           # s
    steps: int
    eroded: int
    turn: float | None   # rad


@dataclass(frozen=True)
class Impact:
    """Of all replicates; where they have no depth, it, its spread (of one run) and its error (of the mean) are None."""
    outcome: str
    depth: float | None   # m
    spread: float | None  # m
    error: float | None   # m
    elements: int
    steps: int
    element_steps: int
    mu: float             # Pa, as it truly is
    energy: dict          # shares of the impact energy
    worst_closure: float
    warnings: list
    runs: list

    def cpu(self):
        """Of a run, s."""
        return statistics.mean(run.cpu for run in self.runs)

    def depth_words(self, scale, digits=2):
        """Depth times `scale` and its error, or how the impact ended."""
        return self.outcome if self.depth is None else plus_minus(scale * self.depth, self.error and scale * self.error, digits)


def impact_of(answer):
    return Impact(answer["outcome"], answer["depth_m"], answer["depth_spread_m"], answer["depth_standard_error_m"], answer["elements"], answer["steps"],
                  answer["element_steps"], answer["mu_true_Pa"], answer["energy"], answer["energy_worst_closure"], answer["findings"],
                  [run_of(run) for run in answer["runs"]])


def run_of(run):
    return Run(run["outcome"], run["depth_m"], run["cpu_s"], run["steps"], run["eroded"], run.get("turn_rad"))


# Scenes and published files.

def changed(text, *replacements):
    """The text with each of the (old, new) in it replaced."""
    for old, new in replacements:
        assert old in text, old
        text = text.replace(old, new)
    return text


def rows_of(file, **where):
    """Rows of a published CSV file, as they are printed there; lines of # are notes."""
    with open(file, newline="") as text:
        rows = list(csv.DictReader(line for line in text if not line.startswith("#")))
    return [row for row in rows if all(row[key] == value for key, value in where.items())]


def with_numbers(rows):
    """The rows with numbers where their texts are numbers."""
    return [{key: number_or_text(value) for key, value in row.items()} for row in rows]


def number_or_text(text):
    try:
        return float(text)
    except ValueError:
        return text


# Numbers in words. What is missing or not finite is a dash.

def number(value, form=".4g"):
    return "-" if value is None or not math.isfinite(value) else f"{value:{form}}"


def in_percent(share, form=".1f"):
    return number(share if share is None else 100 * share, form)


def percent(share, form=".1f"):
    words = in_percent(share, form)
    return words if words == "-" else words + " %"


def percent_off(ours, theirs):
    return percent(None if ours is None or not theirs else ours / theirs - 1, "+.1f")


def um(metres):
    return number(metres if metres is None else 1e6 * metres, ".2f")


def plus_minus(value, error, digits=2):
    return f"{value:.{digits}f}" + ("" if error is None else f" ± {error:.{digits}f}")


def mean_size(shares):
    mean = statistics.mean(abs(share) for share in shares)
    return percent(mean) if math.isfinite(mean) else "none: not all shots stopped"


# Markdown.

def table(head, rows):
    """Texts and whole numbers stand as they are, other numbers with four digits, None as a dash."""
    def line(cells):
        return "| " + " | ".join(number(cell) if cell is None or isinstance(cell, float) else str(cell).replace("|", "\\|") for cell in cells) + " |"
    return "\n".join(map(line, (head, ["---"] * len(head), *rows)))


# gnuplot.

def data_block(name, rows, digits=7):
    return f"${name} << EOD\n" + "\n".join(" ".join(f"{value:.{digits}g}" for value in row) for row in rows) + "\nEOD\n"


def draw(file, script, size="760,440", font=13):
    drawn = subprocess.run(["gnuplot"], input=f'set terminal svg size {size} font "sans,{font}" background rgb "white"\n{script}', stdout=subprocess.PIPE, text=True, check=True)
    file.write_text(drawn.stdout)
