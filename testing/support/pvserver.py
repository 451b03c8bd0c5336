# SPDX-License-Identifier: GPL-3.0-or-later
"""A server of ParaView's on this computer, for as long as a test needs it."""

import contextlib
import shutil
import socket
import subprocess


OWN_MPI = ("PMIX_", "OMPI_COMMAND", "OMPI_ARGV", "OMPI_APP_CTX", "OMPI_MCA_ess", "OMPI_MCA_orte", "OMPI_MCA_pmix")


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def server(environment, plugin, ranks=1):
    """Its port and the number of its process. `plugin`: arguments that load one. `ranks`: more than one are started by MPI."""
    port = free_port()
    # Of the MPI that this process is of itself, if it is pvpython: mpiexec would take itself for a part of that.
    environment = {name: value for name, value in environment.items() if not name.startswith(OWN_MPI)}
    start = [shutil.which("mpiexec"), "-n", str(ranks)] if ranks > 1 else []
    with subprocess.Popen([*start, shutil.which("pvserver"), f"--server-port={port}", *plugin], env=environment,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        try:
            while "Accepting" not in (line := process.stdout.readline()):
                assert line, "the server did not start"
            yield port, process.pid
        finally:
            process.terminate() if ranks > 1 else process.kill()  # MPI ends its ranks
