# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the heads and imports of the scripts and writes what CMake needs: heads.py FOLDER LIST=WORD,WORD... makes
FOLDER/ROOM.cmake of each room, with the jobs of its scripts. README.md says what a head holds. Standard library only.
"""

import ast
import functools
import re
import sys
from collections.abc import Iterator
from pathlib import Path

ANALYSIS = Path(__file__).resolve().parent.parent
KEYS = {"name", "question", "data", "depends", "options", "outputs", "seconds", "for", "when"}
ROOMS = {
    "tables": {"kind": "table", "outputs": "csv tex"},
    "figures": {"kind": "figure", "outputs": "svg png pdf", "seconds": "2 2"},
    "verdicts": {"kind": "verdicts"},
    "findings": {"kind": "table"},
    "paper": {"kind": "text"},
    "report": {"kind": "report"},
    "common": {},
}


@functools.cache
def head(path: Path) -> tuple[dict[str, str], list[dict[str, str]]]:
    """What a file says before its first @name, and all that it says of each name."""
    shared: dict[str, str] = {}
    jobs: list[dict[str, str]] = []
    for key, value in re.findall(r"^# @(\S+) +(.+)$", path.read_text(), re.MULTILINE):
        if key not in KEYS:
            sys.exit(f"{path}: there is no @{key}, see analysis/README.md")
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
    """The file, what it imports, and so on."""
    found = [path]
    for file in found:  # which grows meanwhile
        found += [other for other in imported(file) if other not in found]
    return found


def job_of(script: Path, name: str | None) -> dict[str, str]:
    """What the script's head says of the job of that name, or of its only one."""
    job = next(
        job for job in head(script)[1] if name is None or re.fullmatch(re.sub(r"\b[A-Z]+\b", ".+", job["name"]), name)
    )
    return {**ROOMS[script.resolve().parent.name], **job, "name": name or job["name"]}


def filled(text: str, words: dict[str, str]) -> str:
    """The text with each of the words replaced by what stands for it."""
    return re.sub(r"\b[A-Z]+\b", lambda match: words.get(match[0], match[0]), text)


def expanded(word: str) -> list[str]:
    """A word with {a,b} in it written out, as a shell does; ${VARIABLE} is CMake's."""
    match = re.search(r"(?<!\$)\{([^{}]*)\}", word)
    if not match:
        return [word]
    ends = word[: match.start()], word[match.end() :]
    return [one for choice in match[1].split(",") for one in expanded(choice.join(ends))]


def variants(job: dict[str, str], lists: dict[str, str]) -> Iterator[dict[str, str]]:
    """The job as it is made: once, or for each word of a list."""
    job = {key: filled(text, lists) for key, text in job.items()}
    word, _, values = job.get("for", "").partition(" in ")
    for value in values.split(",") if word else [""]:
        if (value or not word) and job.get("when") != "":
            one = {key: filled(text, {word: value}) for key, text in job.items()}
            yield {key: filled(text, {"NAME": one["name"]}) for key, text in one.items()}


def declared(path: Path, job: dict[str, str]) -> str:
    """A job for CMake. What a file that is imported needs, the script needs too."""
    job = {"seconds": "1 1", **ROOMS[path.parent.name], **job}
    if not {"question", "outputs"} <= job.keys():
        sys.exit(f"{path}: {job['name']} needs @question and @outputs, see analysis/README.md")
    files = reached(path)
    heads = [job, *(head(file)[0] for file in files[1:])]
    data, depends = ([word for lines in heads for word in lines.get(key, "").split()] for key in ("data", "depends"))
    needs = [f"data/{name}.{kind}" for name in data for kind in ("csv", "json")]
    needs += [re.sub("^analysis/", f"{ANALYSIS}/", file) for word in depends for file in expanded(word)]
    outputs = [file if "." in file else f"{path.parent.name}/{job['name']}.{file}" for file in job["outputs"].split()]
    question = job["question"].replace('"', '\\"')
    command = [path, "--results", "${IMPINGE_RESULTS_DIR}", *job.get("options", "").split()]

    def words(texts) -> str:
        return " ".join(f'"{text}"' for text in texts)

    return (
        f"impinge_job(NAME {job['name']} KIND {job['kind']} ARTEFACTS {job['name']} SECONDS {job['seconds']}\n"
        f'  QUESTION {words([question])}\n  OUTPUTS {words(outputs)}\n'
        f"  DEPENDS {words(dict.fromkeys([*needs, *files]))}\n  COMMAND ${{python}} {words(command)})\n"
    )


def main(folder: Path, *lists: str) -> None:
    """Writes the jobs; refuses a file that no script imports."""
    words = dict(text.split("=", 1) for text in lists)
    used = {Path(__file__).resolve()}
    paths = {room: sorted((ANALYSIS / room).glob("*.py")) for room in ROOMS}
    for room in ROOMS:
        jobs = ""
        for path in paths[room]:
            for job in head(path)[1]:
                used |= {*reached(path)}
                jobs += "".join(declared(path, variant) for variant in variants(job, words))
        (folder / f"{room}.cmake").write_text(jobs)
    if unused := [str(path) for room in ROOMS for path in paths[room] if path not in used]:
        sys.exit(f"{unused[0]} has no @name, and no script imports it: see analysis/README.md")


if __name__ == "__main__":
    main(Path(sys.argv[1]), *sys.argv[2:])
