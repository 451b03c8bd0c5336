# SPDX-License-Identifier: GPL-3.0-or-later
"""A server of ParaView's on this computer, for as long as a test needs it."""

import contextlib
import shutil
import socket
import subprocess


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def server(environment, plugin):
    """Its port and the number of its process. `plugin`: arguments that load one."""
    port = free_port()
    with subprocess.Popen([shutil.which("pvserver"), f"--server-port={port}", *plugin], env=environment, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True) as process:
        try:
            while "Accepting" not in (line := process.stdout.readline()):
                assert line, "the server did not start"
            yield port, process.pid
        finally:
            process.kill()
