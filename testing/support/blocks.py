# SPDX-License-Identifier: GPL-3.0-or-later
"""The blocks of a source by name, whatever form ParaView's releases fetch them in."""

from paraview import servermanager

RANK, FIRST = "Block ", "Block 0_"


def of_first_rank(source):
    """Its blocks of the first rank, by name. Fetched, the blocks of several ranks are a block a rank, or since ParaView 6 one list with
    the name of the rank before that of the block, also of a single rank."""
    fetched = servermanager.Fetch(source)
    inner = fetched.GetBlock(0)
    blocks = inner if inner.IsA("vtkMultiBlockDataSet") else fetched
    named = {blocks.GetMetaData(i).Get(blocks.NAME()): blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())}
    return {name.removeprefix(FIRST): block for name, block in named.items() if not name.startswith(RANK) or name.startswith(FIRST)}
