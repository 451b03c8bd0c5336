// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSurfaceMap.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

#include "haptics/geometry/measure/Curvature.h"
#include "haptics/geometry/measure/PatchAround.h"
#include "haptics/geometry/measure/SurfaceFaults.h"
#include "haptics/geometry/measure/WallThickness.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "vtkDoubleArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticMeasuredSurface.h"
#include "vtkHapticPieces.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkHapticSurfaceMap);

namespace
{
using palpate::Vec3;

constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

/// A vertex of the patch.
struct Place
{
  Vec3 Outward_W = Vec3::Zero(); ///< sum over its triangles in the patch, weighted by twice their areas
  std::uint32_t Triangle = 0;    ///< one of them
};

/// Vertices of the patch; triangles that are turned against the rest count as if they were not.
std::map<std::uint32_t, Place> PlacesOf(const palpate::TriangleMesh& mesh, const std::vector<std::uint32_t>& patch)
{
  std::vector<bool> isFlipped(mesh.triangles.size());
  for (const palpate::FlippedPart& part : palpate::findFaults(mesh, 0.0).flipped)
  {
    for (const std::uint32_t triangle : part.triangles)
    {
      isFlipped[triangle] = true;
    }
  }
  std::map<std::uint32_t, Place> places;
  for (const std::uint32_t triangle : patch)
  {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const auto& at = mesh.vertices_W;
    const Vec3 normal_W = (at[b] - at[a]).cross(at[c] - at[a]);
    for (const std::uint32_t corner : mesh.triangles[triangle])
    {
      Place& place = places[corner];
      place.Outward_W += isFlipped[triangle] ? Vec3(-normal_W) : normal_W;
      place.Triangle = triangle;
    }
  }
  return places;
}

vtkDoubleArray* AddMapArray(vtkPolyData* surface, const char* name)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(surface->GetNumberOfPoints());
  array->FillValue(NoValue);
  surface->GetPointData()->AddArray(array);
  return array;
}

/// Fills the arrays of a surface vertex by vertex.
class Gauge
{
public:
  Gauge(const palpate::TriangleMesh& mesh, const palpate::SurfaceTree& tree, vtkPolyData* surface, bool curvature)
    : Mesh(mesh), Tree(tree), Main(AddMapArray(surface, curvature ? "Curvature" : "Thickness")),
      Largest(curvature ? AddMapArray(surface, "CurvatureLargest") : nullptr),
      Least(curvature ? AddMapArray(surface, "CurvatureLeast") : nullptr)
  {
    surface->GetPointData()->SetActiveScalars(this->Main->GetName());
  }

  void Look(std::uint32_t vertex, const Place& place)
  {
    const Vec3& p_W = this->Mesh.vertices_W[vertex];
    const Vec3 outward_W = place.Outward_W.normalized();
    if (!(outward_W.norm() > 0.5)) // the triangles cancel out
    {
      return;
    }
    if (!this->Largest)
    {
      this->Main->SetValue(vertex, palpate::wallThickness_u(this->Tree, p_W, -outward_W).value_or(NoValue));
    }
    else if (const auto found = palpate::curvatureAt(this->Tree, this->TriangleOf(place), p_W, outward_W))
    {
      this->Main->SetValue(vertex, found->mean_per_u());
      this->Largest->SetValue(vertex, found->largest_per_u);
      this->Least->SetValue(vertex, found->least_per_u);
    }
  }

  [[nodiscard]] std::string Sentence(double radius_u) const
  {
    double range[2];
    this->Main->GetFiniteRange(range, 0);
    std::ostringstream text;
    text.precision(4);
    text << (this->Largest ? "Mean curvature" : "Wall thickness") << " within " << radius_u << " u: ";
    if (range[0] > range[1])
    {
      text << (this->Largest ? "not known." : "no wall is behind the surface.");
      return text.str();
    }
    text << range[0] + 0.0 << " to " << range[1] + 0.0 << // a plane has no minus zero
      (this->Largest ? " 1/u." : " u.");
    return text.str();
  }

private:
  /// Cleaning may have given the triangle another number.
  [[nodiscard]] std::uint32_t TriangleOf(const Place& place) const
  {
    const auto& [a, b, c] = this->Mesh.triangles[place.Triangle];
    const auto& at = this->Mesh.vertices_W;
    return palpate::nearestOn(this->Tree.data(), (at[a] + at[b] + at[c]) / 3.0).triangle;
  }

  const palpate::TriangleMesh& Mesh;
  const palpate::SurfaceTree& Tree;
  vtkDoubleArray* Main;
  vtkDoubleArray* Largest;
  vtkDoubleArray* Least;
};
} // namespace

void vtkHapticSurfaceMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quantity: " << (this->Quantity == Curvature ? "Curvature" : "Thickness") << "\n";
  os << indent << "Centre: " << this->Centre[0] << ", " << this->Centre[1] << ", " << this->Centre[2] << " u\n";
  os << indent << "Radius: " << this->Radius << " u\n";
  os << indent << "Text: " << this->Text << "\n";
}

std::string vtkHapticSurfaceMap::Map(vtkPolyData* surface)
{
  const vtkHapticConversionResult converted = vtkHapticToMesh(surface);
  std::string problem = converted.Problem;
  const auto tree = converted.Mesh ? vtkHapticMeasuredSurface(surface, problem) : nullptr;
  if (!tree)
  {
    return problem;
  }
  const palpate::TriangleMesh& mesh = *converted.Mesh; // vertices are numbered as the points
  const double radius_u = this->Radius > 0.0 ? this->Radius : 0.1 * (tree->data().high_W - tree->data().low_W).norm();
  const auto patch = palpate::patchAround(mesh, Vec3(this->Centre), radius_u);
  if (patch.empty())
  {
    std::ostringstream text;
    text << "no point of the surface is within " << radius_u << " u of (" << this->Centre[0] << ", " << this->Centre[1]
         << ", " << this->Centre[2] << "); set Centre to a place on the surface, or enlarge Radius";
    return text.str();
  }
  const auto places = PlacesOf(mesh, patch);
  Gauge gauge(mesh, *tree, surface, this->Quantity == Curvature);
  std::size_t looked = 0;
  for (const auto& [vertex, place] : places)
  {
    constexpr std::size_t atOnce = 256;
    if (looked++ % atOnce == 0)
    {
      this->UpdateProgress(static_cast<double>(looked) / static_cast<double>(places.size()));
      if (this->CheckAbort())
      {
        break;
      }
    }
    gauge.Look(vertex, place);
  }
  this->Text = gauge.Sentence(radius_u);
  return {};
}

int vtkHapticSurfaceMap::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->Text.clear();
  if (const std::string refusal = vtkHapticRefusePieces(output); !refusal.empty())
  {
    vtkErrorMacro("Nothing is measured: " << refusal);
    return 0;
  }
  const vtkSmartPointer<vtkDataSet> whole = vtkHapticGatherDataSet(vtkPolyData::GetData(input[0]));
  if (vtkHapticRank() > 0)
  {
    return 1; // the first rank has the surface
  }
  vtkPolyData* const mapped = vtkPolyData::GetData(output);
  mapped->ShallowCopy(whole);
  if (const std::string problem = this->Map(mapped); !problem.empty())
  {
    mapped->Initialize();
    vtkErrorMacro("There is no map: " << problem);
    return 0;
  }
  return 1;
}
