# SPDX-License-Identifier: GPL-3.0-or-later
"""A cohort on a real Slurm: munge, slurmctld and two slurmd of Debian's slurm-wlm on loopback, without systemd, started
here and ended by their process ids. An array of 12 shards; a node that is killed under its task; a shard that fails and
is run again; a merge with the bytes of one machine. IMPINGE names the program, SOURCE the clone.
"""

import getpass
import hashlib
import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

IMPINGE = os.environ["IMPINGE"]
BATCH = Path(os.environ["SOURCE"]) / "experiments" / "cohort.sbatch"
NODES = ("one", "two")
SHARDS = 12
STUDY = {
    "title": "a cohort on loopback",
    "hips": 180,
    "seed": 7,
    "faces": 2000,
    "start": "normal",
    "parameters": {"version": {"distribution": "normal", "mean": 19, "sd": 5, "source": "test"}},
    "questions": ["limits"],
}
CONF = """\
ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ctld}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={root}/munge.sock,cred_expire=10
CredType=cred/munge
StateSaveLocation={root}/state
SlurmdSpoolDir={root}/spool-%n
SlurmctldPidFile={root}/ctld.pid
SlurmdPidFile={root}/slurmd-%n.pid
SlurmctldLogFile={root}/ctld.log
SlurmdLogFile={root}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
SlurmdTimeout=10
KillWait=2
MinJobAge=3600
SlurmctldDebug=info
NodeName=one NodeAddr=127.0.0.1 NodeHostname={host} Port={one} CPUs=1 RealMemory=1000
NodeName=two NodeAddr=127.0.0.1 NodeHostname={host} Port={two} CPUs=1 RealMemory=1000
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count: int) -> list[int]:
    taken = [socket.socket() for _ in range(count)]
    for one in taken:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in taken]
    for one in taken:
        one.close()
    return ports


class Cluster:
    """Daemons in the foreground, each a process of its own group."""

    def __init__(self, root: Path):
        self.root = root
        self.processes: dict[str, subprocess.Popen] = {}
        for folder in ("state", *(f"spool-{name}" for name in NODES)):
            (root / folder).mkdir()
        ctld, one, two = free_ports(3)
        host = socket.gethostname().split(".")[0]
        (root / "slurm.conf").write_text(
            CONF.format(root=root, host=host, user=getpass.getuser(), ctld=ctld, one=one, two=two)
        )
        self.environment = {**os.environ, "SLURM_CONF": str(root / "slurm.conf"), "IMPINGE": IMPINGE}
        key = root / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.start("munged", "munged", "--foreground", "--force", f"--key-file={key}", f"--socket={root}/munge.sock",
                   f"--pid-file={root}/munged.pid", f"--log-file={root}/munged.log", f"--seed-file={root}/munged.seed")
        self.wait("munge's socket", (root / "munge.sock").exists)
        self.start("slurmctld", "slurmctld", "-D", "-f", root / "slurm.conf")
        for name in NODES:
            self.start_node(name)
        self.wait("both nodes idle", lambda: self.said("sinfo", "-h", "-N", "-o", "%t").split() == ["idle"] * 2)

    def start(self, name: str, *words) -> None:
        program = shutil.which(words[0], path=os.environ["PATH"] + ":/usr/sbin:/sbin")
        with (self.root / f"{name}.out").open("ab") as out:
            self.processes[name] = subprocess.Popen(
                [program, *map(str, words[1:])], stdout=out, stderr=out, env=self.environment, start_new_session=True
            )

    def start_node(self, name: str) -> None:
        self.start(name, "slurmd", "-D", "-N", name, "-f", self.root / "slurm.conf")

    def kill_node(self, name: str) -> None:
        """As when its power fails: the daemon, and all that runs below it, by their ids."""
        left = [self.processes[name].pid, *self.steps_of(name)]
        while left:
            process = left.pop()
            left += children_of(process)
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.processes.pop(name).wait()

    def signal_steps(self, name: str, what: signal.Signals) -> None:
        for process in self.steps_of(name):
            try:
                os.kill(process, what)
            except ProcessLookupError:
                pass

    def steps_of(self, name: str) -> list[int]:
        """The tasks of a node, which know where they run, and the shepherds that Slurm starts them with: these are no
        children of its daemon."""
        wanted = {f"SLURMD_NODENAME={name}".encode(), f"SLURM_CONF={self.root}/slurm.conf".encode()}
        found = []
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                if wanted <= set((folder / "environ").read_bytes().split(b"\0")):
                    found.append(int(folder.name))
                    parent = int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1])
                    if b"slurmstepd" in Path(f"/proc/{parent}/cmdline").read_bytes():
                        found.append(parent)
            except OSError:
                continue
        return found

    def stop(self) -> None:
        self.said("scancel", "--user", getpass.getuser())
        time.sleep(1)
        for name in [name for name in NODES if name in self.processes]:
            self.kill_node(name)
        for process in reversed(self.processes.values()):
            process.terminate()
        for process in self.processes.values():
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def said(self, *words) -> str:
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False, env=self.environment)
        return done.stdout.strip()

    def wait(self, what: str, is_so, seconds: float = 120) -> None:
        end = time.monotonic() + seconds
        while not is_so():
            if time.monotonic() > end:
                raise TimeoutError(f"{what}: not within {seconds:.0f} s; see {self.root}\n{self.logs()}")
            time.sleep(0.2)

    def logs(self) -> str:
        return "\n".join(
            f"{log.name}: " + log.read_text(errors="replace")[-1500:] for log in sorted(self.root.glob("*.log"))
        )


def children_of(process: int) -> list[int]:
    found = []
    for task in Path(f"/proc/{process}/task").glob("*/children"):
        try:
            found += map(int, task.read_text().split())
        except OSError:
            continue
    return found


class Slurm(unittest.TestCase):
    def setUp(self):
        self.root = Path(tempfile.mkdtemp(prefix="impinge-slurm-"))
        self.addCleanup(shutil.rmtree, self.root, ignore_errors=True)
        (self.root / "cluster").mkdir()
        self.study = self.root / "study.json"
        self.study.write_text(json.dumps(STUDY))
        self.out = self.root / "out"
        self.cluster = None
        self.addCleanup(lambda: self.cluster and self.cluster.stop())
        self.cluster = Cluster(self.root / "cluster")

    def submit(self, array: str, *words) -> str:
        job = self.cluster.said("sbatch", "--parsable", f"--array={array}", "--chdir", self.root, *words[:-3], BATCH, *words[-3:])
        self.assertTrue(job.isdigit(), job)
        return job

    def tasks(self, job: str) -> dict[int, dict[str, str]]:
        """What Slurm says of each task."""
        found = {}
        for line in self.cluster.said("scontrol", "show", "job", job, "--oneliner").splitlines():
            words = dict(word.split("=", 1) for word in line.split() if "=" in word)
            if words.get("ArrayTaskId", "").isdigit():
                found[int(words["ArrayTaskId"])] = words
        return found

    def states(self, job: str) -> list[str]:
        return [words["JobState"] for words in self.tasks(job).values()]

    def end_of(self, job: str, seconds: float = 600) -> dict[int, dict[str, str]]:
        over = {"COMPLETED", "FAILED", "CANCELLED", "NODE_FAIL", "TIMEOUT"}
        self.cluster.wait(f"the end of job {job}", lambda: self.states(job) and set(self.states(job)) <= over, seconds)
        return self.tasks(job)

    def test_an_array_a_lost_node_a_shard_that_fails_and_the_bytes_of_one_machine(self):
        alone = self.root / "alone"  # in the meantime
        one_machine = subprocess.Popen([IMPINGE, "cohort", "--study", self.study, "--out", alone], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(one_machine.wait)
        (self.out / "shards").mkdir(parents=True)
        (self.out / "shards" / f"5-of-{SHARDS}.rows").write_text("no shard\n")  # so that its task fails
        job = self.submit(f"1-{SHARDS}", self.study, self.out, SHARDS)

        def running() -> list[int]:
            return [i for i, words in self.tasks(job).items()
                    if words["JobState"] == "RUNNING" and words.get("NodeList") == "two"]

        def held() -> list[int]:
            """As running(), and kept from its end: a task is over in two seconds."""
            self.cluster.signal_steps("two", signal.SIGSTOP)
            time.sleep(1)  # what was said before is heard
            found = running()
            if not found or not self.cluster.steps_of("two"):
                self.cluster.signal_steps("two", signal.SIGCONT)
                return []
            return found

        self.cluster.wait("a task on node two", lambda: running() and held())
        lost = running()[0]
        self.cluster.kill_node("two")
        self.cluster.wait("the task of the dead node back in the queue", lambda: int(self.tasks(job)[lost]["Restarts"]) > 0)
        self.cluster.start_node("two")
        states = {i: words["JobState"] for i, words in self.end_of(job).items()}
        self.assertEqual(states, {i: "FAILED" if i == 5 else "COMPLETED" for i in range(1, SHARDS + 1)},
                         self.cluster.logs())
        merged = subprocess.run([IMPINGE, "cohort", "--merge", self.out], capture_output=True, text=True, check=False)
        self.assertIn(f"shard 5 of {SHARDS} cannot be merged, the first because", merged.stderr)
        (self.out / "shards" / f"5-of-{SHARDS}.rows").unlink()
        again = self.submit("5", self.study, self.out, SHARDS)
        self.assertEqual({words["JobState"] for words in self.end_of(again).values()}, {"COMPLETED"}, self.cluster.logs())
        merge = self.cluster.said("sbatch", "--parsable", f"--dependency=afterok:{again}", "--chdir", self.root,
                                  "--wrap", f"{IMPINGE} cohort --merge {self.out}")
        self.cluster.wait("the merge", (self.out / "cohort.json").exists)
        self.assertTrue(merge.isdigit())
        self.assertEqual(one_machine.wait(), 0)
        subprocess.run([IMPINGE, "cohort", "--merge", alone], check=True, capture_output=True)
        for name in ("cohort.csv", "cohort.json"):
            self.assertEqual(*(hashlib.sha256((folder / name).read_bytes()).hexdigest() for folder in (self.out, alone)))


if __name__ == "__main__":
    unittest.main()
