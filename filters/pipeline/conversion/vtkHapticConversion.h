// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticConversion_h
#define vtkHapticConversion_h

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;
class vtkMatrix4x4;
class vtkPolyData;

/// How polygons were cut into triangles, to cut the same ones again wherever their corners have gone.
struct vtkHapticCuts
{
  struct Part
  {
    std::uint64_t Polygons =
      0; ///< names them by the ids of their corners; 0: elsewhere they may have to be cut in another way
    std::size_t FirstTriangle = 0;
    std::size_t Triangles = 0;
    std::uint32_t FirstVertex = 0;
  };
  std::shared_ptr<const palpate::TriangleMesh> Mesh;
  std::vector<Part> Parts; ///< one a data set
};

/// Triangles in W, or why there are none.
struct vtkHapticConversionResult
{
  std::shared_ptr<const palpate::TriangleMesh> Mesh; ///< null on a problem
  std::string Problem;                               ///< one line without a name in front; empty when Mesh is there
  vtkHapticCuts Cuts;                                ///< of polygons
  std::vector<std::size_t> PartPoints; ///< vertices from each data set in turn, 0 from one without the requested cells
  std::vector<std::size_t> HoleEdges;  ///< edges round each polygon that could not be filled
};

/// All polygons and strips of a data object as triangles, placed by `matrix` (data frame to W; null: identity).
///
/// Poly data as it is; any other data set through its outer faces; composite data block by block. Scale, shear and
/// mirror are baked into the vertices, and a mirror turns the corners around, so that outside stays outside. Nothing
/// is cleaned: NaN points and degenerate triangles are for cleaning to report. Polygons of any shape are cut by
/// palpate::cutPolygon(), so that no hole is in a surface that had none; those with a corner that is not finite stay
/// holes (HoleEdges). VTK's own triangle filter is not used: it leaves out polygons that it cannot cut. The input is
/// not changed and no array of it is kept. `known`: cuts of an earlier time step. Where a diagonal runs depends on
/// where the corners are; a part with the same polygons is cut as it was, so that a surface that only deforms keeps its
/// triangles.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticConversionResult vtkHapticToMesh(
  vtkDataObject* data, vtkMatrix4x4* matrix = nullptr, const vtkHapticCuts* known = nullptr);

/// All lines and poly-lines of a data object as the segments of curves (palpate::segmentsOf()), placed alike. The
/// radius they are touched with is the caller's: it is in W and takes no part in the placement. Not the edges of
/// polygons.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticConversionResult vtkHapticToLines(
  vtkDataObject* data, vtkMatrix4x4* matrix = nullptr);

/// Lines and poly-lines in the poly data of a data object.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::size_t vtkHapticCountLines(vtkDataObject* data);

/// Results of `visit` for a data set, or for each one in a composite, in order.
VTKHAPTICPIPELINE_EXPORT void vtkHapticForEachDataSet(
  vtkDataObject* data, const std::function<void(vtkDataSet&)>& visit);

/// The surfaces whose points are the vertices of the mesh that was made of `data`, with their arrays: all parts with
/// points. Empty when `partPoints` are not of these data.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<vtkSmartPointer<vtkPolyData>> vtkHapticSurfaceParts(
  vtkDataObject* data, const std::vector<std::size_t>& partPoints);

/// Triangles as poly data with points in double precision: vertices and triangles keep their order.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkPolyData> vtkHapticToPolyData(
  const palpate::TriangleMesh& mesh);

/// Names the geometry of a data object placed by `matrix` (null: identity): of poly data its points and cells, of other
/// data all of it. Modification times are unique within a process, so equal keys mean equal geometry, and a change of
/// either changes the key; arrays of poly data do not count.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::uint64_t vtkHapticContentKey(vtkDataObject* data, vtkMatrix4x4* matrix);

#endif
