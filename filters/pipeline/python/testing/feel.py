# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces along a path: the filter Touch Along Path with settings by their names."""

import difflib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkGeometryFilter

from palpate.vtkHapticPipeline import vtkTouchAlongPath

PER_METRE = {"nm": 1e9, "um": 1e6, "mm": 1e3, "cm": 1e2, "m": 1.0, "km": 1e-3}


class Refused(AssertionError):
    """Data that cannot be judged: one sentence with the file, the reason and the remedy."""


def data_of(surface):
    """The data of a source of paraview.simple, an algorithm, its output port, or as they are."""
    if hasattr(surface, "SMProxy"):
        from paraview import servermanager  # only a script of ParaView has such a source

        return servermanager.Fetch(surface)
    if isinstance(surface, vtkAlgorithm):
        surface = surface.GetOutputPort()
    if isinstance(surface, vtkAlgorithmOutput):
        surface.GetProducer().Update()
        surface = surface.GetProducer().GetOutputDataObject(surface.GetIndex())
    if not isinstance(surface, (vtkDataSet, vtkCompositeDataSet)):
        raise Refused(f"{surface!r} cannot be touched: pass data, an algorithm, its output port or a source of ParaView.")
    if not surface.GetNumberOfElements(vtkDataObject.POINT):
        raise Refused("The surface is empty: check the pipeline that makes the surface.")
    return surface


def updated(algorithm):
    """The output of an algorithm; its first error is raised instead of being printed."""
    errors = []

    def note(_object, _event, text=""):
        errors.append(text)

    note.CallDataType = "string0"
    observer = algorithm.AddObserver("ErrorEvent", note)
    executive = algorithm.GetExecutive().AddObserver("ErrorEvent", note)
    algorithm.Update()
    algorithm.RemoveObserver(observer)
    algorithm.GetExecutive().RemoveObserver(executive)
    if errors:
        raise Refused(errors[0].strip().splitlines()[-1])
    return algorithm.GetOutput()


def faces_of(surface):
    """The outside of data, of all blocks together, as poly data."""
    geometry = vtkGeometryFilter() if surface.IsA("vtkDataSet") else vtkCompositeDataGeometryFilter()
    geometry.SetInputData(surface)
    return updated(geometry)


class Touch:
    """How a surface is touched: the unit of its scene and settings of the filter."""

    def __init__(self, unit, settings):
        if unit not in PER_METRE:
            raise Refused(f"The unit {unit!r} is unknown: use one of {', '.join(PER_METRE)}.")
        self.unit = unit
        plain = {name: _plain(value) for name, value in settings.items()}
        self.settings = {"Scale": PER_METRE[unit], "Stiffness": 500.0, **plain}
        self._filter()  # a setting that the filter lacks is refused before anything is computed

    @property
    def scale(self):
        """Scene units a metre of the hand."""
        return self.settings["Scale"]

    @property
    def feels_field(self):
        """Whether numbers in space are felt, and not the faces of the data."""
        return any(name.startswith("Field") for name in self.settings)

    def along(self, path, surface):
        """Force on the hand at each row of t, x, y, z [s, scene units], and where its proxy is: (n, 3) [N], (n, 3) [u]."""
        touch = self._filter()
        touch.SetInputDataObject(0, surface)
        touch.SetPathData(_way(path))
        touch.SetTimeArray("t")
        output = updated(touch)
        if output.GetNumberOfPoints() != len(path):
            raise Refused("Nothing could be touched: the surface has no faces.")
        return tuple(vtk_to_numpy(array).astype(float)
                     for array in (output.GetPointData().GetArray("Force"), output.GetPoints().GetData()))

    def _filter(self):
        touch = vtkTouchAlongPath()
        there = touch.GetSettingNames().split()
        for name, value in self.settings.items():
            values = value if isinstance(value, list) else [value]
            if name not in there:
                near = difflib.get_close_matches(name, there, 1)
                raise Refused(f"Touch Along Path has no setting {name}{f'; is {near[0]} meant?' if near else '.'}")
            size = touch.GetSettingSize(name)
            if len(values) != max(1, size) or any(isinstance(each, str) != (size == 0) for each in values):
                raise Refused(f"{name}={value!r} cannot be set: it is {f'{size} number(s)' if size else 'a text'}.")
            touch.SetSetting(name, *(each if size == 0 else float(each) for each in values))
        return touch


def _plain(value):
    """A value as a baseline can hold it: numbers of numpy as Python's, tuples as lists."""
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    return list(value) if isinstance(value, tuple) else value


def _way(path):
    """Rows of t, x, y, z as poly data whose points have the array t."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(path[:, 1:4]), deep=True))
    times = numpy_to_vtk(np.ascontiguousarray(path[:, 0]), deep=True)
    times.SetName("t")
    way = vtkPolyData()
    way.SetPoints(points)
    way.GetPointData().AddArray(times)
    return way
