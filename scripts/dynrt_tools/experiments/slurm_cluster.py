# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A Slurm cluster of one node for tests: Debian's munged, slurmctld and slurmd, of this user and
with all their files in a folder."""

import os
import pathlib
import pwd
import socket
import subprocess
import time
from collections.abc import Sequence

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch")
# The system's folder of daemons is not on every user's PATH.
PATH = f"{os.environ['PATH']}:/usr/sbin:/sbin"
SECONDS = 60  # more than the daemons ever take to start or to end

# The node says to have what the profile of a report asks for, whatever this computer has. Nothing needs
# cgroups, systemd or another user.
CONFIGURATION = """\
ClusterName=dynrt
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CredType=cred/munge
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmdSpoolDir={folder}/spool
StateSaveLocation={folder}/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
MailProg=/bin/true
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
KillWait=2
SlurmdParameters=config_overrides
NodeName=node NodeHostname={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=16384
PartitionName=all Nodes=node Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(number: int) -> list[int]:
    """Ports of this computer that nobody listens at."""
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(number)]
    ports = [int(one.getsockname()[1]) for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Cluster:
    """Runs from start() to stop(). `environment` is that of a user of the cluster."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        self.environment = {
            **os.environ,
            "PATH": PATH,
            "SLURM_CONF": str(folder / "slurm.conf"),
            "CI": "true",  # Snakemake asks for its jobs every second, not every ten
        }
        self.user = pwd.getpwuid(os.getuid()).pw_name
        self._daemons: list[subprocess.Popen[bytes]] = []

    def start(self) -> None:
        for name in ("munge", "spool", "state"):
            (self.folder / name).mkdir(parents=True, mode=0o700)
        text = CONFIGURATION.format(
            folder=self.folder,
            user=self.user,
            host=socket.gethostname().partition(".")[0],
            ports=free_ports(2),
        )
        (self.folder / "slurm.conf").write_text(text, encoding="utf-8")
        munge = self.folder / "munge"
        (munge / "key").touch(mode=0o600)
        (munge / "key").write_bytes(os.urandom(128))
        files = [f"--{name}-file={munge / name}" for name in ("key", "pid", "log", "seed")]
        # It would refuse root, and a folder that others may write to.
        self._run("munged", "--foreground", "--force", f"--socket={munge / 'socket'}", *files)
        self._wait_for("munge", "--no-input", f"--socket={munge / 'socket'}")
        self._run("slurmctld", "-D")
        self._run("slurmd", "-D", "-N", "node")
        self._wait_for("sinfo", "--noheader", "--states=idle", "--format=%t", said="idle")

    def stop(self) -> None:
        """Ends the jobs and the daemons."""
        self.command("scancel", f"--user={self.user}")
        self._wait_for("squeue", "--noheader", said="")
        for daemon in reversed(self._daemons):
            daemon.terminate()
        for daemon in reversed(self._daemons):
            try:
                daemon.wait(SECONDS)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def command(self, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            words, env=self.environment, capture_output=True, text=True, check=False
        )

    def queue(self) -> list[str]:
        """The names of the jobs that wait or run."""
        return self.command("squeue", "--noheader", "--format=%j").stdout.split()

    def _run(self, *words: str) -> None:
        with (self.folder / f"{words[0]}.log").open("wb") as log:
            self._daemons.append(
                subprocess.Popen(words, env=self.environment, stdout=log, stderr=log)
            )

    def _wait_for(self, *words: str, said: str | None = None) -> None:
        """Until the command succeeds and, if that is given, says this."""
        for _ in range(10 * SECONDS):
            result = self.command(*words)
            if result.returncode == 0 and said in (None, result.stdout.strip()):
                return
            time.sleep(0.1)
        raise AssertionError(f"{self._why(words)}\n{result.stdout}{result.stderr}")

    def _why(self, words: Sequence[str]) -> str:
        logs = "\n".join(path.read_text(errors="replace") for path in self.folder.glob("*.log"))
        return f"'{' '.join(words)}' did not come to its end in {SECONDS} seconds:\n{logs}"
