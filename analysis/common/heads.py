# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the heads of scripts and experiments, and the imports of scripts: which jobs they are. README.md says what stands
in the head of a script, experiments/CMakeLists.txt in that of an experiment. Standard library only.
"""

import ast
import functools
import re
import sys
from collections.abc import Iterator
from pathlib import Path

ANALYSIS = Path(__file__).resolve().parent.parent
KEYS = {
    "#": {"name", "question", "data", "depends", "options", "outputs", "seconds", "for", "when"},
    "//": {"question", "writes", "writes-with-bones", "files", "files-with-bones", "bones", "timing", "reads", "seconds",
           "links"},
}  # fmt: skip
ROOMS = {
    "tables": {"kind": "table", "outputs": "csv json tex"},
    "figures": {"kind": "figure", "outputs": "svg png pdf", "seconds": "2 2"},
    "verdicts": {"kind": "verdicts"},
    "findings": {"kind": "table"},
    "paper": {"kind": "text"},
    "report": {"kind": "report"},
    "common": {},
}


@functools.cache
def head(path: Path) -> tuple[dict[str, str], list[dict[str, str]]]:
    """What a file says before its first @name, and what it says about each name."""
    shared: dict[str, str] = {}
    jobs: list[dict[str, str]] = []
    mark = "//" if path.suffix == ".cpp" else "#"
    for key, value in re.findall(rf"^{mark} @(\S+) +(.+)$", path.read_text(), re.MULTILINE):
        if key not in KEYS[mark]:
            where = "experiments/CMakeLists.txt" if mark == "//" else "analysis/README.md"
            sys.exit(f"{path}: there is no @{key}, see {where}")
        if key == "name":
            jobs.append({**shared})
        lines = jobs[-1] if jobs else shared
        lines[key] = f"{lines[key]} {value}" if key in lines else value
    return shared, jobs


@functools.cache
def imported(path: Path) -> list[Path]:
    """The files of this folder that a file imports."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom):
            names |= {node.module.split(".")[0], node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
        elif isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
    files = [ANALYSIS / f"{name.replace('.', '/')}{end}" for name in sorted(names) for end in (".py", "/__init__.py")]
    return [file for file in files if file.is_file()]


def reached(path: Path) -> list[Path]:
    """The file, its imports, their imports, and so on."""
    found = [path]
    for file in found:  # which grows meanwhile
        found += [other for other in imported(file) if other not in found]
    return found


def unused() -> list[Path]:
    """Files that no script imports."""
    files = [path for room in ROOMS for path in sorted((ANALYSIS / room).glob("*.py"))]
    used = {file for path in files if head(path)[1] for file in reached(path)}
    return [path for path in files if path not in used]


def job_of(script: Path, name: str | None) -> dict[str, str]:
    """What the script's head says about the job with that name, or about its only job."""
    job = next(
        job for job in head(script)[1] if name is None or re.fullmatch(re.sub(r"\b[A-Z]+\b", ".+", job["name"]), name)
    )
    return {**ROOMS[script.resolve().parent.name], **job, "name": name or job["name"]}


def filled(text: str, words: dict[str, str]) -> str:
    """The text with each of the words replaced by its value."""
    return re.sub(r"\b[A-Z]+\b", lambda match: words.get(match[0], match[0]), text)


def expanded(word: str) -> list[str]:
    """Expands a word: {a,b} to several words, and * to the project's matching files."""
    if match := re.search(r"\{([^{}]*)\}", word):
        ends = word[: match.start()], word[match.end() :]
        return [one for choice in match[1].split(",") for one in expanded(choice.join(ends))]
    project = ANALYSIS.parent
    return [str(file.relative_to(project)) for file in sorted(project.glob(word))] if "*" in word else [word]


def variants(job: dict[str, str], lists: dict[str, str]) -> Iterator[dict[str, str]]:
    """The job in the variants in which it is made: once, or for each word of a list."""
    job = {key: filled(text, lists) for key, text in job.items()}
    word, _, values = job.get("for", "").partition(" in ")
    for value in values.split(",") if word else [""]:
        if (value or not word) and job.get("when") != "":
            one = {key: filled(text, {word: value}) for key, text in job.items()}
            yield {key: filled(text, {"NAME": one["name"]}) for key, text in one.items()}


def declared(path: Path, job: dict[str, str], results: Path) -> dict:
    """The fields of a Job (jobs.py). A script needs what the files that it imports need."""
    room = path.parent.name
    job = {"seconds": "1 1", **ROOMS[room], **job}
    if not {"question", "outputs"} <= job.keys():
        sys.exit(f"{path}: {job['name']} needs @question and @outputs, see analysis/README.md")
    files = reached(path)
    heads = [job, *(head(file)[0] for file in files[1:])]
    data, depends = ([word for lines in heads for word in lines.get(key, "").split()] for key in ("data", "depends"))
    needs = [f"data/{name}.{kind}" for name in data for kind in ("csv", "json")]
    needs += [file for word in depends for file in expanded(word)]
    needs += [str(file.relative_to(ANALYSIS.parent)) for file in files]
    return {
        "name": job["name"],
        "kind": job["kind"],
        "question": job["question"],
        "script": str(path.relative_to(ANALYSIS.parent)),
        "outputs": [file if "." in file else f"{room}/{job['name']}.{file}" for file in job["outputs"].split()],
        "depends": [*dict.fromkeys(needs)],
        "command": ["env", f"PYTHONPATH={ANALYSIS}", sys.executable, str(path), "--results", str(results),
                    *job.get("options", "").split()],
        "budget": [float(text) for text in job["seconds"].split()],
    }  # fmt: skip


def script_jobs(room: str, lists: dict[str, str], results: Path) -> list[dict]:
    """The jobs of all scripts in a folder. `lists` gives the values of words such as JOINTS, for example "a,b"."""
    paths = sorted((ANALYSIS / room).glob("*.py"))
    return [
        declared(path, job, results) for path in paths for lines in head(path)[1] for job in variants(lines, lists)
    ]
