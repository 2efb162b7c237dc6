# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the scripts of analysis/, each in a copy of a Python that has imported what they share: half a second less a script.

run_graph.py calls start(), and job.py ask(). The server ends when nobody is left who could ask: with the run, killed or not.
"""

from __future__ import annotations

import contextlib
import json
import os
import runpy
import select
import signal
import socket
import subprocess
import sys
import traceback
from pathlib import Path

SOCKET = "IMPINGE_SCRIPTS"  # environment variable: number of the socket that asks
LARGEST = 1 << 16  # bytes of what is asked


def parts(command: list[str]) -> tuple[str, str, list[str]] | None:
    """PYTHONPATH=..., interpreter, and script with its options, of a command of analysis/; of another, none."""
    if command[1:3] == ["-E", "env"] and command[5:6] == ["-B"]:
        return command[3], command[4], command[6:]
    return None


def start(command: list[str], folder: Path) -> tuple[subprocess.Popen, socket.socket]:
    """A server for commands like this one, whose paths are relative to the folder, and the socket that asks it."""
    path, interpreter, _ = parts(command)
    asks, asked = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    asks.set_inheritable(True)
    words = ["env", path, interpreter, "-B", __file__, str(asked.fileno())]
    with asked:
        return subprocess.Popen(words, cwd=folder, pass_fds=[asked.fileno()]), asks


class Asked:
    """A script that the server runs; as much of subprocess.Popen as job.py needs. Its pid is 0 where no server is left."""

    def __init__(self, words: list[str], folder: Path):
        read, write = os.pipe()
        told, tells = os.pipe()
        self.stdout, self.told = os.fdopen(read, errors="replace"), os.fdopen(told)
        asks = socket.socket(fileno=os.dup(int(os.environ[SOCKET])))
        with asks, contextlib.suppress(OSError), os.fdopen(write, "w"), os.fdopen(tells, "w"):
            socket.send_fds(asks, [json.dumps({"words": words, "folder": str(folder)}).encode()], [write, tells])
        self.pid = int(self.told.readline() or 0)

    def wait(self, timeout: float | None = None) -> int:
        """Its exit code; 1 if it ended without one."""
        if not select.select([self.told], [], [], timeout)[0]:
            raise subprocess.TimeoutExpired("script", timeout or 0)
        with self.told:
            return int(self.told.readline() or 1)


def ask(command: list[str], folder: Path) -> Asked | None:
    """Runs a command of analysis/ in the folder; none where nobody serves."""
    found = parts(command) if SOCKET in os.environ else None
    asked = Asked(found[2], folder) if found else None
    return asked if asked and asked.pid else None


def run(words: list[str]) -> int:
    """Runs the script as Python does; its exit code."""
    sys.argv = words
    sys.path[0] = str(Path(words[0]).parent)
    try:
        runpy.run_path(words[0], run_name="__main__")
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:  # noqa: BLE001  # whatever it was, one script failed and the server goes on
        traceback.print_exc()
        return 1
    return 0


def serve(number: int) -> None:
    """One script after another begins; they run beside each other."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever asked ends its script
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody waits for them here
    with socket.socket(fileno=number) as asked:
        while True:
            text, files, _, _ = socket.recv_fds(asked, LARGEST, 2)
            if not text:
                return
            import common  # noqa: F401, PLC0415  # now: who asks holds the machine, so that no timing runs beside it

            if os.fork() == 0:
                asked.close()
                signal.signal(signal.SIGINT, signal.default_int_handler)
                signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                os.setsid()
                words = json.loads(text)
                os.chdir(words["folder"])
                for stream in (sys.stdout, sys.stderr):
                    os.dup2(files[0], stream.fileno())
                os.write(files[1], f"{os.getpid()}\n".encode())
                code = run(words["words"])
                for stream in (sys.stdout, sys.stderr):
                    with contextlib.suppress(OSError):
                        stream.flush()
                os.write(files[1], f"{code}\n".encode())
                os._exit(code)
            for file in files:
                os.close(file)


if __name__ == "__main__":
    serve(int(sys.argv[1]))
