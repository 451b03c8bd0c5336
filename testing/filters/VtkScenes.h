// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Before anything says `using namespace palpate`, after which `testing` in these headers would have two meanings.
#include <gmock/gmock.h>

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"
#include "vtkSmartPointer.h"

class vtkAlgorithm;
class vtkObject;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace palpate::testing
{

/// Two triangles over [-size, size]^2 in the plane z = tilt y [u].
[[nodiscard]] vtkSmartPointer<vtkPolyData> makePlane(double size, double tilt = 0.0);

/// vtkSphereSource at the origin, triangles pointing out [u].
[[nodiscard]] vtkSmartPointer<vtkPolyData> makeSphere(double radius, int resolution);

/// One polyline through the points [u].
[[nodiscard]] vtkSmartPointer<vtkPolyData> makePath(const std::vector<Vec3>& points_W);

/// Soft Body of tetrahedra that fill [-side / 2, side / 2]^2 below z = 0, half as high, fixed below [u].
[[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> makeSoftBlock(double side, double unit_m);

/// The volume that the triangles enclose, positive if they point out.
[[nodiscard]] double enclosedVolume(const TriangleMesh& mesh);

/// Runs the algorithm and returns the errors that its executive and it reported; prints nothing.
[[nodiscard]] std::vector<std::string> errorsOf(vtkAlgorithm* algorithm);

/// Runs `change` and returns the errors that the object reported, in order; prints nothing.
[[nodiscard]] std::vector<std::string> errorsOf(vtkObject* object, const std::function<void()>& change);

} // namespace palpate::testing
