#!/usr/bin/env python3
"""Counts the work of two revisions on the same sums and fails if a sum became dearer.

Valgrind's callgrind counts instructions, and the program itself counts decisions and allocations.
A busy machine does not blur these counts, but they depend on the compiler and its flags. So both
revisions are built here, alike. Each sum is computed twice in a process; the second is counted.

  compare.py v1 v2        two revisions
  compare.py v1           a revision and the working tree as it is

Ends with 1 if a sum takes more instructions than the limit allows, or has another result; without
valgrind it goes by the number of decisions.
"""
import argparse
import math
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def run(*words, **more):
    return subprocess.run([str(w) for w in words], check=True, text=True, **more)


def output(*words):
    return run(*words, stdout=subprocess.PIPE).stdout


def source_of(revision, folder):
    """Returns (name, folder) of a tree of the revision. None is the working tree."""
    if revision is None:
        return "working-tree", ROOT
    commit = output("git", "-C", ROOT, "rev-parse", "--short=12", f"{revision}^{{commit}}").strip()
    tree = folder / commit / "source"
    if not tree.exists():
        part = tree.with_suffix(".part")
        shutil.rmtree(part, ignore_errors=True)
        part.mkdir(parents=True)
        archive = subprocess.Popen(["git", "-C", str(ROOT), "archive", commit],
                                   stdout=subprocess.PIPE)
        run("tar", "-x", "-C", part, stdin=archive.stdout)
        if archive.wait() != 0:
            sys.exit(f"git archive {commit} failed")
        part.rename(tree)
    return commit, tree


def build(name, source, folder, jobs):
    """Builds the counted program on the library of `source`; returns its path."""
    here = folder / name / "build"
    here.mkdir(parents=True, exist_ok=True)
    log = here / "log.txt"
    print(f"building {name}", flush=True)
    with log.open("w") as out:
        for words in (["cmake", "-S", HERE, "-B", here, f"-DMINKSUM_SOURCE={source}",
                       "-DCMAKE_BUILD_TYPE=Release"],
                      ["cmake", "--build", here, "-j", jobs, "--target", "minksum_work"]):
            done = subprocess.run([str(w) for w in words], stdout=out, stderr=subprocess.STDOUT)
            if done.returncode != 0:
                sys.exit(f"{name} could not be built: see {log}")
    return here / "minksum_work"


def instructions(program, name):
    file = program.parent / "callgrind.out"
    run("valgrind", "--quiet", "--tool=callgrind", "--toggle-collect=counted_sum*",
        f"--callgrind-out-file={file}", program, name, "quiet")
    for line in file.read_text().splitlines():
        if line.startswith(("totals:", "summary:")):
            return int(line.split()[1])
    sys.exit(f"callgrind gave no total for {name}")


def count(program, name, with_valgrind):
    counts = dict(line.split() for line in output(program, name).splitlines())
    counts = {key: int(value) for key, value in counts.items()}
    counts["decisions"] = counts["by_filter"] + counts["exactly"]
    if with_valgrind:
        counts["instructions"] = instructions(program, name)
    return counts


def change(old, new):
    return new / old if old else (1.0 if new == 0 else math.inf)


def row(name, old, new, measures, limit):
    """Returns a line of the table, its deciding ratio, and what is wrong with it."""
    words = []
    for measure in measures:
        words.append(f"{old[measure]:>14,}{new[measure]:>14,}"
                     f"{change(old[measure], new[measure]):>7.3f}")
    ratio = change(old[measures[0]], new[measures[0]])
    faults = []
    if ratio > 1 + limit / 100:
        faults.append("DEARER")
    if old["fingerprint"] != new["fingerprint"]:
        faults.append("ANOTHER RESULT")
    words.append(f"{old['allocations']:>7,}{new['allocations']:>7,}")
    return f"{name:<50}" + "".join(words) + "  " + ", ".join(faults), ratio, faults


def compare(programs, names, limit, with_valgrind):
    measures = (["instructions"] if with_valgrind else []) + ["decisions"]
    head = "".join(f"{measure:>14}{'new':>14}{'ratio':>7}" for measure in measures)
    print(f"{'':<50}{head}{'allocs':>7}{'new':>7}")
    ratios, faults = [], 0
    for name in names:
        old, new = (count(program, name, with_valgrind) for program in programs)
        line, ratio, wrong = row(name, old, new, measures, limit)
        print(line, flush=True)
        ratios.append(ratio)
        faults += bool(wrong)
    finite = [r for r in ratios if 0 < r < math.inf]
    if finite:
        mean = math.exp(sum(map(math.log, finite)) / len(finite))
        print(f"geometric mean of {measures[0]}: {mean:.4f} times the base's")
    if faults:
        print(f"{faults} of {len(names)} sums rose by more than {limit:g} % or have another result")
    return faults == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("base", help="a git revision")
    parser.add_argument("new", nargs="?", help="another one (default: the working tree)")
    parser.add_argument("--limit", type=float, default=2, help="per cent that a sum may rise")
    parser.add_argument("--only", default="", help="only sums with this in their names")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "compare",
                        help="where revisions are built (default: build/compare)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of the compiler")
    words = parser.parse_args()
    with_valgrind = shutil.which("valgrind") is not None
    if not with_valgrind:
        print("valgrind is not there (make deps-bench installs it): decisions are counted, but no "
              "instructions")
    folder = words.folder.resolve()
    programs = [build(*source_of(revision, folder), folder, words.jobs)
                for revision in (words.base, words.new)]
    old, new = (output(program).splitlines() for program in programs)
    names = [n for n in new if n in old and words.only in n]
    if not names:
        sys.exit("no sum to count")
    return 0 if compare(programs, names, words.limit, with_valgrind) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as error:
        sys.exit(f"failed: {' '.join(error.cmd)}")
