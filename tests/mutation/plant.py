"""Plants faults in a copy of the sources, one at a time, and says which tests catch each.

    python3 tests/mutation/plant.py COPY [--only WORDS]     COPY: a clean checkout of its own, which is built in COPY/build/release
    python3 tests/mutation/plant.py --check SOURCE          whether every fault still has its place; seconds

A fault is caught where a fast test fails that is not a pin of the solver's bits, which any change moves. Twenty faults take about an hour of processor time.
Ends with 1 where one is not caught. Written afterwards: nothing; every file is as it was."""
import argparse
import pathlib
import re
import subprocess
import sys
import time

from faults import FAULTS

NOT_COUNTED = "-Slow*:*Pinned*"
LONGEST = 240  # s, of a test program; sound ones take less than a minute


def misplaced(source):
    return [f"{fault.name}: {count} times in {fault.file}" for fault in FAULTS
            if (count := (source / fault.file).read_text().count(fault.text)) != 1]


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)


def build(copy, programs):
    done = run("cmake", "--build", copy / "build/release", "--target", *programs)
    return "" if done.returncode == 0 else done.stdout[-2000:] + done.stderr[-2000:]


def failures(copy, program):
    """Names of failed tests; the program's end where it did not come to its summary. A fault may keep a run from ending."""
    command = [str(copy / "build/release/tests" / program), f"--gtest_filter={NOT_COUNTED}", "--gtest_brief=1"]
    try:
        done = run(*command, cwd=copy / "build/release/tests", timeout=LONGEST)
        text, end = done.stdout, "" if done.returncode == 0 else f"{program} ended with {done.returncode}"
    except subprocess.TimeoutExpired as late:
        text, end = (late.stdout or b"").decode(errors="replace"), f"{program} did not end within {LONGEST} s"
    failed = re.findall(r"^\[  FAILED  \] (\S+?),? .*\(\d+ ms\)$", text, re.M)
    return failed or ([end] if end else [])


def caught_by(copy, fault):
    file = copy / fault.file
    whole = file.read_text()
    programs = [f"{layer}_test" for layer in fault.tests]
    try:
        file.write_text(whole.replace(fault.text, fault.instead))
        if broken := build(copy, programs):
            return [f"the compiler: {broken}"]
        return [name for program in programs for name in failures(copy, program)]
    finally:
        file.write_text(whole)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", default="", help="faults whose name has these words")
    options = parser.parse_args()
    options.source = options.source.resolve()
    if wrong := misplaced(options.source):
        sys.exit("no place for a fault:\n" + "\n".join(wrong))
    if options.check:
        return
    chosen = [fault for fault in FAULTS if options.only in fault.name]
    programs = sorted({f"{layer}_test" for fault in chosen for layer in fault.tests})
    if broken := build(options.source, programs):
        sys.exit("does not build without a fault:\n" + broken)
    if sound := [name for program in programs for name in failures(options.source, program)]:
        sys.exit("tests fail without a fault: " + ", ".join(sound))
    missed = 0
    for fault in chosen:
        start = time.monotonic()
        tests = caught_by(options.source, fault)
        missed += not tests
        shown = ", ".join(tests[:3]) + (f" and {len(tests) - 3} more" if len(tests) > 3 else "") if tests else "NOT CAUGHT"
        print(f"{fault.name}: {shown} ({time.monotonic() - start:.0f} s)", flush=True)
    print(f"{len(chosen) - missed} of {len(chosen)} caught")
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
