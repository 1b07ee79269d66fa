#!/usr/bin/env python3
"""Plants each fault of mutations.json in a copy of the project, and expects a test to fail.

Exits 0 if every fault chosen is caught and every test passes without it, 1 if not, 2 for wrong
usage or a list that does not fit the code. See README.md.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import queue
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIST = pathlib.Path(__file__).resolve().with_name("mutations.json")
WORK = ROOT / "build" / "mutations"
TARGETS = ("unit", "gpu", "image", "extremes", "cli")
SOURCE_FOLDERS = ("host", "shaders")
SOURCE_KINDS = (".h", ".cpp", ".glsl", ".comp")
KEYS = ("fault", "file", "from", "to", "target", "filter")
# A compiler cache then gives one copy what it compiled for another, precompiled headers included.
CACHE_SETTINGS = {"CCACHE_BASEDIR": str(WORK), "CCACHE_SLOPPINESS": "pch_defines,time_macros"}
# The slowest filter takes a minute on two cores; a fault that never ends is not caught.
TEST_SECONDS = 600


class ListError(Exception):
    """What is wrong with the list, in one sentence."""


# --- The list -------------------------------------------------------------------------------------


def load_mutations():
    mutations = json.loads(LIST.read_text(encoding="utf-8"))
    for number, mutation in enumerate(mutations, start=1):
        mutation["number"] = number
    return mutations


def pattern_of(text):
    """Matches the text however its words are broken into lines."""
    return re.compile(r"\s+".join(re.escape(word) for word in text.split()))


def sources():
    """The text of every file that a fault may be planted in, by path from the root."""
    return {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8")
            for folder in SOURCE_FOLDERS for path in sorted((ROOT / folder).rglob("*"))
            if path.suffix in SOURCE_KINDS}


def find_moved_text(mutation, texts):
    """Sets the mutation's file to the one that has its text, where only one other file has it. True
    if it was moved."""
    pattern = pattern_of(mutation["from"])
    if pattern.search(texts.get(mutation["file"], "")):
        return False
    holders = [path for path, text in texts.items() if pattern.search(text)]
    if len(holders) != 1:
        return False
    mutation["file"] = holders[0]
    return True


def check_mutation(mutation, test_sources, texts):
    """Throws ListError unless the fault can be planted and its tests exist."""
    if tuple(key for key in mutation if key != "number") != KEYS:
        raise ListError(f"does not have the keys {', '.join(KEYS)}, in this order")
    if "\n" in mutation["from"] + mutation["to"] or mutation["from"] == mutation["to"]:
        raise ListError("must change one line")
    if mutation["file"] not in texts:
        raise ListError(f"names {mutation['file']}, which is no source file, and no other file has "
                        f"its text once: {mutation['from']}")
    count = len(pattern_of(mutation["from"]).findall(texts[mutation["file"]]))
    if count != 1:
        raise ListError(f"has a text that occurs {count} times in {mutation['file']}, not once: "
                        f"{mutation['from']}")
    if mutation["target"] not in TARGETS:
        raise ListError(f"has a target that is not one of {', '.join(TARGETS)}")
    for pattern in mutation["filter"].split(":"):
        match = re.fullmatch(r"\*?(\w+)\.(\w+)(/\S+)?", pattern)
        if not match:
            raise ListError(f"has a filter that does not name suite and test in full: {pattern}")
        test = re.compile(rf"TEST(_F|_P)?\(\s*{match[1]},\s*{match[2]}\s*\)")
        found = test.search(test_sources[mutation["target"]])
        if not found:
            raise ListError(f"names {match[1]}.{match[2]}, which is no test in "
                            f"tests/{mutation['target']}")
        has_parameters = found[1] == "_P"
        if has_parameters != (pattern.startswith("*") and match[3] is not None):
            raise ListError(f"has a filter that fits no test; those with parameters are named "
                            f"*SUITE.TEST/INSTANCE: {pattern}")


def check_list(mutations):
    """Prints what is wrong with the list on stderr, and finds text that moved to another file. True if
    every fault can be planted."""
    texts = sources()
    for mutation in mutations:
        if find_moved_text(mutation, texts):
            print(f"mutations.json: the text of entry {mutation['number']} is now in "
                  f"{mutation['file']}; --update writes that down", file=sys.stderr)
    test_sources = {
        target: "".join(path.read_text(encoding="utf-8")
                        for path in (ROOT / "tests" / target).glob("*.cpp"))
        for target in TARGETS
    }
    sound = True
    for mutation in mutations:
        try:
            check_mutation(mutation, test_sources, texts)
        except ListError as error:
            print(f"mutations.json: entry {mutation['number']} ({mutation.get('fault')}) {error}",
                  file=sys.stderr)
            sound = False
    return sound


def write_list(mutations):
    """Writes the list without what load_mutations added to it."""
    entries = [{key: mutation[key] for key in KEYS} for mutation in mutations]
    LIST.write_text(json.dumps(entries, indent=4, ensure_ascii=False) + "\n", encoding="utf-8")


def choose(mutations, selectors):
    """Those with the number, the target, or a part of any text of the entry; all without selector."""
    def is_chosen(mutation, selector):
        if selector.isdigit():
            return mutation["number"] == int(selector)
        if selector in TARGETS:
            return mutation["target"] == selector
        return any(selector.lower() in mutation[key].lower() for key in KEYS)

    return [mutation for mutation in mutations
            if not selectors or any(is_chosen(mutation, selector) for selector in selectors)]


# --- The copy -------------------------------------------------------------------------------------


def project_files():
    """Relative paths of what is tracked, or untracked and not ignored."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return [path for path in listed.split("\0") if path and (ROOT / path).is_file()]


def synchronise(source):
    """Makes `source` equal to the project. Equal files keep their times, so that builds are short."""
    files = project_files()
    for file in files:
        original, copy = ROOT / file, source / file
        if not copy.is_file() or copy.read_bytes() != original.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(original, copy)
    known = {source / file for file in files}
    for folder in {pathlib.PurePath(file).parts[0] for file in files if "/" in file}:
        for path in (source / folder).rglob("*"):
            if path.is_file() and path not in known:
                path.unlink()


class Planted:
    """Holds a fault in the copy for as long as the `with` block lasts."""

    def __init__(self, source, mutation):
        self.path = source / mutation["file"]
        self.mutation = mutation

    def __enter__(self):
        self.original = self.path.read_text(encoding="utf-8")
        planted = pattern_of(self.mutation["from"]).sub(lambda _: self.mutation["to"], self.original)
        self.path.write_text(planted, encoding="utf-8")

    def __exit__(self, *_):
        self.path.write_text(self.original, encoding="utf-8")


# --- Building and testing -------------------------------------------------------------------------


class Project:
    """A copy and its build."""

    def __init__(self, work, build_jobs):
        self.build_jobs = build_jobs
        work.mkdir(parents=True, exist_ok=True)
        self.source = work / "source"
        self.build_folder = work / "build"
        self.report = work / "report.json"
        self.source.mkdir(exist_ok=True)
        synchronise(self.source)
        self.source = self.source.resolve()
        # A compiler cache, where there is one, saves most of a copy's first build.
        cache = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        subprocess.run(["cmake", "--preset", "release", "-B", self.build_folder.resolve(),
                        "-DCALOTYPE_BUILD_TESTS=ON", "--log-level=WARNING"] + cache,
                       cwd=self.source, check=True, stdout=subprocess.DEVNULL)

    def build(self, target):
        """The compiler's words where it fails, else None."""
        done = subprocess.run(
            ["cmake", "--build", self.build_folder, "--target", f"{target}_tests",
             "--parallel", str(self.build_jobs)],
            capture_output=True, text=True, env=os.environ | CACHE_SETTINGS)
        return done.stdout + done.stderr if done.returncode != 0 else None

    def test(self, target, test_filter):
        """Runs the tests: (what happened, names of those that failed). What happened is "passed",
        "failed", "nothing ran", "crashed" or "timed out"."""
        self.report.unlink(missing_ok=True)
        program = self.build_folder.resolve() / "tests" / f"{target}_tests"
        try:
            done = subprocess.run(
                [program, f"--gtest_filter={without_slow(test_filter)}", f"--gtest_output=json:{self.report}"],
                cwd=self.source, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                timeout=TEST_SECONDS)
        except subprocess.TimeoutExpired:
            return "timed out", []
        if done.returncode not in (0, 1) or not self.report.exists():
            return "crashed", []
        return self.outcome(json.loads(self.report.read_text(encoding="utf-8")))

    @staticmethod
    def outcome(report):
        ran = 0
        failed = []
        for suite in report["testsuites"]:
            for test in suite["testsuite"]:
                ran += test["result"] == "COMPLETED"
                if "failures" in test:
                    names = f"{suite['name'].split('/')[-1]}.{test['name'].split('/')[0]}"
                    failed.append(names)
        if failed:
            return "failed", failed
        return ("passed" if ran > 0 else "nothing ran"), []


def without_slow(test_filter):
    """The filter without the slow twins of its tests: ./bootstrap test must catch the fault."""
    return test_filter if "Slow" in test_filter else test_filter + "-*Slow*"


def names_with_counts(failed):
    return ", ".join(name if failed.count(name) == 1 else f"{name} ({failed.count(name)})"
                     for name in dict.fromkeys(failed))


def builds(project, mutations):
    """Builds what the mutations need, as the code is."""
    for target in dict.fromkeys(mutation["target"] for mutation in mutations):
        error = project.build(target)
        if error:
            print(f"the project does not build:\n{error}", file=sys.stderr)
            return False
    return True


def unmutated_passes(project, mutations):
    """Runs every filter on the code as it is."""
    passes = True
    for target, test_filter in dict.fromkeys((m["target"], m["filter"]) for m in mutations):
        result, failed = project.test(target, test_filter)
        if result != "passed":
            print(f"without any fault: {target} {test_filter}: {result} "
                  f"{names_with_counts(failed)}", file=sys.stderr)
            passes = False
    return passes


def catch(project, mutation):
    """By what the fault is caught, or None with what happened instead on stderr."""
    with Planted(project.source, mutation):
        error = project.build(mutation["target"])
        if error:
            result = f"does not build:\n{error}"
        else:
            result, failed = project.test(mutation["target"], mutation["filter"])
            if result == "failed":
                return names_with_counts(failed)
    print(f"entry {mutation['number']} is not caught: {result}", file=sys.stderr)
    return None


def plant_all(project, waiting, results):
    """Plants faults until none is waiting, and prints a line of the table for each."""
    while True:
        try:
            mutation = waiting.get_nowait()
        except queue.Empty:
            return
        by = catch(project, mutation)
        results.append(by is not None)
        print(f"| {mutation['number']} | {mutation['fault']} | `{mutation['file']}` | "
              f"{by or '**nothing**'} |", flush=True)


def run(mutations, jobs):
    """Plants the faults in as many copies of the project at a time as there are jobs."""
    started = time.monotonic()
    cores = os.cpu_count()
    projects = []
    for number in range(1, jobs + 1):
        projects.append(Project(WORK / str(number), build_jobs=cores))
        if not builds(projects[-1], mutations):
            return False
    for project in projects:
        project.build_jobs = max(cores // jobs, 1)
    print("| # | fault | planted in | caught by |\n|---|---|---|---|", flush=True)
    results = []
    # Tests of time run alone, as in CTest: what runs beside them could make them fail.
    timed = [mutation for mutation in mutations if "Timed" in mutation["filter"]]
    others = [mutation for mutation in mutations if "Timed" not in mutation["filter"]]
    for chosen, copies in ((others, projects), (timed, projects[:1])):
        if not unmutated_passes(projects[0], chosen):
            return False
        waiting = queue.SimpleQueue()
        for mutation in chosen:
            waiting.put(mutation)
        with concurrent.futures.ThreadPoolExecutor(len(copies)) as pool:
            for done in [pool.submit(plant_all, copy, waiting, results) for copy in copies]:
                done.result()
    minutes = (time.monotonic() - started) / 60.0
    print(f"\n{sum(results)} of {len(mutations)} faults caught, in {minutes:.0f} minutes on "
          f"{cores} cores.")
    return sum(results) == len(mutations)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true",
                        help="only check that every fault can be planted and names real tests")
    parser.add_argument("--update", action="store_true",
                        help="only write down the new file of each text that moved")
    parser.add_argument("--jobs", type=int, default=1, metavar="N",
                        help="copies of the project to plant faults in at a time; each takes a "
                             "build of its own (default: 1)")
    parser.add_argument("selector", nargs="*", metavar="NUMBER|TARGET|TEXT",
                        help="faults to plant: by number, by target, or by a part of the entry; "
                             "default: all")
    arguments = parser.parse_args()
    if arguments.update and arguments.selector:
        parser.error("--update is for the whole list; leave out " + " ".join(arguments.selector))
    if arguments.jobs < 1:
        parser.error("--jobs must be at least 1")
    mutations = choose(load_mutations(), arguments.selector)
    if not mutations:
        parser.error("no entry of mutations.json has " + " or ".join(arguments.selector))
    if not check_list(mutations):
        return 2
    if arguments.update:
        write_list(mutations)
    if arguments.check or arguments.update:
        return 0
    return 0 if run(mutations, arguments.jobs) else 1


if __name__ == "__main__":
    sys.exit(main())
