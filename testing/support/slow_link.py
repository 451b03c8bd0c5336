# SPDX-License-Identifier: GPL-3.0-or-later
"""A connection that answers late: every byte between a client and a server of this computer travels for a while.

A process of its own, for a client that waits for its server lets no other thread run.
"""

import asyncio
import contextlib
import shutil
import subprocess
import sys


async def _carry(reader, writer, delay_s):
    """Incoming bytes go out later, in their order."""
    loop = asyncio.get_running_loop()
    with contextlib.suppress(ConnectionError):
        while data := await reader.read(1 << 20):
            loop.call_later(delay_s, writer.write, data)
    loop.call_later(delay_s, writer.close)


async def _serve(port, delay_s):
    async def meet(reader, writer):
        there_reader, there_writer = await asyncio.open_connection("localhost", port)
        await asyncio.gather(_carry(reader, there_writer, delay_s), _carry(there_reader, writer, delay_s))

    server = await asyncio.start_server(meet, "127.0.0.1", 0)
    print(server.sockets[0].getsockname()[1], flush=True)
    await server.serve_forever()


@contextlib.contextmanager
def slow_link(port, round_trip_s):
    """The port that leads to the listener on `port`, with half of that time in each direction."""
    with subprocess.Popen([shutil.which("python3"), __file__, str(port), str(round_trip_s / 2)], stdout=subprocess.PIPE,
                          text=True) as process:
        try:
            yield int(process.stdout.readline())
        finally:
            process.kill()


if __name__ == "__main__":
    asyncio.run(_serve(int(sys.argv[1]), float(sys.argv[2])))
