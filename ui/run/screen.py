# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a whole Xvfb screen, with no X tools: the server started with -fbdir keeps the screen in an XWD file."""

import os
import struct

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter


def read_screen(framebuffer_dir):
    """The screen as an array (height, width, 3) of RGB bytes. Raises OSError or ValueError with the reason."""
    with open(os.path.join(framebuffer_dir, "Xvfb_screen0"), "rb") as file:
        data = file.read()
    head = struct.unpack(">25I", data[:100])
    width, height, depth, line, colours = head[4], head[5], head[11], head[12], head[19]
    if depth != 32:
        raise ValueError(f"the screen has {depth} bits a pixel, expected 32: start Xvfb with a depth of 24")
    start = head[0] + 12 * colours  # header, then the colour map
    rows = numpy.frombuffer(data, numpy.uint8, height * line, start).reshape(height, line)
    return rows[:, : width * 4].reshape(height, width, 4)[:, :, 2::-1]


def save_screen(framebuffer_dir, png):
    """Writes the screen to the PNG file `png`."""
    pixels = numpy.ascontiguousarray(read_screen(framebuffer_dir)[::-1])  # VTK's rows go upwards
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(png)
    writer.SetInputData(image)
    writer.Write()
