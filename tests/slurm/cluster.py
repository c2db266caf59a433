"""A Slurm cluster of one node, this machine, that needs root and Debian's slurm-wlm and munge, and leaves
nothing behind."""

import os
import pwd
import random
import signal
import socket
import subprocess
import time
from pathlib import Path

# Jobs of several ranks run at the same time, also where the machine has fewer cores. Requeued jobs start
# after seconds, not minutes. Job numbers name folders in /tmp, which other clusters of this machine must not
# use.
CONFIGURATION = """\
ClusterName=weavefront
FirstJobId={first_job}
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ctld_port}
SlurmdPort={slurmd_port}
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CryptoType=crypto/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault={mpi}
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0
ReturnToService=2
JobRequeue=1
OverTimeLimit=0
KillWait=10
MinJobAge=3600
NodeName={host} NodeAddr=127.0.0.1 CPUs=8 RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Cluster:
    """Context of a cluster with its files in `folder`; `environment` is that of its commands."""

    def __init__(self, folder, mpi):
        self.folder, self.daemons = Path(folder), []
        folder.mkdir(parents=True)
        folder.parent.chmod(0o711)  # munged and slurmd ask for a way to their sockets
        ctld_port, slurmd_port = free_ports(2)
        for name in ("state", "spool"):
            (folder / name).mkdir()
        self.host = socket.gethostname().split(".")[0]
        configuration = CONFIGURATION.format(
            folder=folder,
            host=self.host,
            ctld_port=ctld_port,
            slurmd_port=slurmd_port,
            mpi=mpi,
            first_job=random.randrange(1, 10**6),
        )
        (folder / "slurm.conf").write_text(configuration)
        (folder / "munge.key").write_bytes(os.urandom(1024))
        (folder / "munge.key").chmod(0o600)
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf"), "TZ": "UTC"}

    def __enter__(self):
        try:
            private = [
                f"--{name}={self.folder}/{file}"
                for name, file in (
                    ("socket", "munge.socket"),
                    ("key-file", "munge.key"),
                    ("log-file", "munged.log"),
                    ("pid-file", "munged.pid"),
                    ("seed-file", "munged.seed"),
                )
            ]
            self.start("munged", "--foreground", "--force", *private)
            self.wait_for(lambda: (self.folder / "munge.socket").exists(), 10)
            self.start("slurmctld", "-D")
            self.start("slurmd", "-D", "-N", self.host)
            self.wait_for(lambda: "idle" in self.call("sinfo", "--noheader", "--format=%T", check=False), 60)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        subprocess.run(
            ["scancel", "--full", "--user", pwd.getpwuid(os.getuid()).pw_name],
            env=self.environment,
            capture_output=True,
            timeout=60,
        )
        for daemon in reversed(self.daemons):
            daemon.send_signal(signal.SIGTERM)
            try:
                daemon.wait(timeout=20)
            except subprocess.TimeoutExpired:
                daemon.kill()

    def start(self, *command):
        with open(self.folder / f"{command[0]}.out", "w") as out:
            path = os.pathsep.join((os.environ["PATH"], "/usr/sbin"))
            self.daemons.append(
                subprocess.Popen(
                    command,
                    env={**self.environment, "PATH": path},
                    stdout=out,
                    stderr=out,
                    start_new_session=True,
                )
            )

    def wait_for(self, condition, seconds):
        end = time.monotonic() + seconds
        while not condition():
            assert (
                all(daemon.poll() is None for daemon in self.daemons) and time.monotonic() < end
            ), self.logs()
            time.sleep(0.2)

    def logs(self):
        return "\n".join(
            path.name + ":\n" + path.read_text()[-3000:]
            for path in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out"))
        )

    def call(self, *command, check=True):
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=60)
        assert not check or done.returncode == 0, (command, done)
        return done.stdout.strip()
