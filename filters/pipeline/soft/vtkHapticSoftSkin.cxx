// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSoftSkin.h"

#include "haptics/compliance/map/SurfaceMap.h"
#include "haptics/session/settings/Setting.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticConversion.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <numeric>

vtkStandardNewMacro(vtkHapticSoftSkin);

namespace
{
constexpr const char* MarkName = "SoftSkin";
/// Triangles that leave less of their area open than this share are a closed surface.
constexpr double ClosedWithin = 1e-6;

palpate::Vec3 At(vtkPoints& points, vtkIdType i)
{
  double p[3];
  points.GetPoint(i, p);
  return palpate::Vec3(p);
}

/// Three numbers of a point of a body; 0 where the body has no such array, as older files have no Dent.
palpate::Vec3 Of(vtkUnstructuredGrid& body, const char* name, vtkIdType point)
{
  vtkDataArray* const array = body.GetPointData()->GetArray(name);
  const bool has = array && array->GetNumberOfComponents() == 3;
  return has ? palpate::Vec3(array->GetTuple3(point)) : palpate::Vec3(palpate::Vec3::Zero());
}

/// Such an array of the nodes that a surface rides on.
Eigen::VectorXd OfNodes(vtkUnstructuredGrid& body, const char* name, const std::vector<std::uint32_t>& sourceVertex)
{
  Eigen::VectorXd ofNodes(3 * static_cast<Eigen::Index>(sourceVertex.size()));
  for (std::size_t v = 0; v < sourceVertex.size(); ++v)
  {
    ofNodes.segment<3>(3 * static_cast<Eigen::Index>(v)) = Of(body, name, sourceVertex[v]);
  }
  return ofNodes;
}

vtkSmartPointer<vtkDoubleArray> Vectors(const char* name, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(tuples);
  return array;
}

double VolumeOf(const palpate::TetraMesh& mesh)
{
  return std::accumulate(mesh.tetras.begin(), mesh.tetras.end(), 0.0,
    [&mesh](double sum, const palpate::Tetra& t) { return sum + palpate::volumeOf(mesh, t); });
}

/// 0 where it is not closed, by the sum of its triangles' areas as vectors.
double VolumeIn(vtkPolyData& surface)
{
  const vtkHapticConversionResult read = vtkHapticToMesh(&surface);
  palpate::Vec3 open = palpate::Vec3::Zero();
  double area = 0.0, volume_u3 = 0.0;
  for (std::size_t i = 0; read.Mesh && i < read.Mesh->triangles.size(); ++i)
  {
    const auto& [a, b, c] = read.Mesh->triangles[i];
    const std::vector<palpate::Vec3>& at = read.Mesh->vertices_W;
    const palpate::Vec3 twice = (at[b] - at[a]).cross(at[c] - at[a]);
    open += twice;
    area += twice.norm();
    volume_u3 += at[a].dot(at[b].cross(at[c])) / 6.0;
  }
  return open.norm() <= ClosedWithin * area ? std::abs(volume_u3) : 0.0;
}

/// The differences between the tetrahedra and the surface that is seen.
std::string ErrorText(vtkPolyData& surface, const palpate::TetraMesh& mesh, const palpate::Embedding& embedding)
{
  const std::size_t points = embedding.map.size();
  std::string text = std::to_string(embedding.outside) + " of " + std::to_string(points) +
                     " points are outside the tetrahedra" +
                     (embedding.outside > 0 ? ", within " + palpate::quantity(embedding.farthest_u, "u") : "");
  if (const double volume_u3 = VolumeIn(surface); volume_u3 > 0.0)
  {
    const double share = VolumeOf(mesh) / volume_u3 - 1.0;
    text += "; the volume of the tetrahedra is " +
            (std::abs(share) < ClosedWithin
                ? "equal to"
                : palpate::quantity(std::abs(100.0 * share), "%") + (share < 0.0 ? " below" : " above")) +
            " that of the surface";
  }
  return text + "; details finer than the tetrahedra deform with them";
}
} // namespace

/// The points of a surface in the tetrahedra of a body at rest.
struct vtkHapticSoftSkin::Riders
{
  const void* Body = nullptr; ///< its array of moduli: another object each time it is made anew
  vtkMTimeType BodyTime = 0;
  const void* Points = nullptr; ///< of the surface
  vtkMTimeType SurfaceTime = 0;
  palpate::Embedding Embedding;
  std::vector<std::uint32_t> SourceVertex; ///< of each node, in the body

  [[nodiscard]] bool IsOf(vtkPolyData& surface, vtkDataArray& young) const
  {
    return this->Body == &young && this->BodyTime == young.GetMTime() && this->Points == surface.GetPoints() &&
           this->SurfaceTime == surface.GetMTime();
  }
};

vtkHapticSoftSkin::vtkHapticSoftSkin()
{
  this->SetNumberOfInputPorts(2);
}

vtkHapticSoftSkin::~vtkHapticSoftSkin() = default;

void vtkHapticSoftSkin::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Text: " << this->Text << "\n";
}

int vtkHapticSoftSkin::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkUnstructuredGrid");
  return 1;
}

bool vtkHapticSoftSkin::IsSkin(vtkDataObject* data)
{
  return data && data->GetFieldData() && data->GetFieldData()->GetArray(MarkName);
}

bool vtkHapticSoftSkin::Ride(vtkPolyData& surface, vtkUnstructuredGrid& body, std::string& problem)
{
  vtkDataArray* const young = body.GetCellData()->GetArray("Young");
  vtkDataArray* const moved = body.GetPointData()->GetArray(vtkHapticBodyWay::DisplacementName);
  if (!moved || moved->GetNumberOfComponents() != 3)
  {
    this->Kept.reset();
    problem = "the body has no array Displacement: apply the filter Soft Body first";
    return false;
  }
  if (this->Kept && young && this->Kept->IsOf(surface, *young))
  {
    return true;
  }
  this->Kept.reset();
  const vtkHapticSoftBodyResult read = vtkHapticToSoftBody(&body);
  problem = read.Input ? "" : "the body: " + read.Problem;
  problem = problem.empty() && surface.GetNumberOfPoints() == 0 ? "the surface has no points" : problem;
  if (!problem.empty())
  {
    return false;
  }
  for (std::size_t v = 0; v < read.Input->mesh.vertices_W.size(); ++v)
  {
    const auto point = static_cast<vtkIdType>(v);
    read.Input->mesh.vertices_W[v] -=
      Of(body, vtkHapticBodyWay::DisplacementName, point) + Of(body, vtkHapticBodyWay::DentName, point);
  }
  palpate::CheckedTetras checked = palpate::checkTetras(read.Input->mesh, read.Input->fixed);
  problem = checked.refusal;
  if (!problem.empty())
  {
    return false;
  }
  std::vector<palpate::Vec3> points_W;
  for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i)
  {
    points_W.push_back(At(*surface.GetPoints(), i));
  }
  this->Kept = std::make_unique<Riders>(Riders{ young, young->GetMTime(), surface.GetPoints(), surface.GetMTime(),
    palpate::embed(checked.mesh, points_W), std::move(checked.sourceVertex) });
  this->Text = ErrorText(surface, checked.mesh, this->Kept->Embedding);
  return true;
}

int vtkHapticSoftSkin::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  const vtkSmartPointer<vtkDataSet> whole = vtkHapticGatherDataSet(vtkDataSet::GetData(input[0]));
  const vtkSmartPointer<vtkDataSet> bodies = vtkHapticGatherDataSet(vtkDataSet::GetData(input[1]));
  const bool first = vtkHapticRank() == 0; // which has the skin
  auto* const surface = vtkPolyData::SafeDownCast(whole);
  auto* const body = vtkUnstructuredGrid::SafeDownCast(bodies);
  std::string problem;
  if (first && !this->Ride(*surface, *body, problem))
  {
    this->Text.clear();
    vtkErrorMacro("The surface cannot follow the body: " << problem);
  }
  const bool rides = vtkHapticHoldsOnAllRanks(problem.empty());
  if (!rides || !first)
  {
    return rides ? 1 : 0;
  }
  const Eigen::VectorXd movedBy = OfNodes(*body, vtkHapticBodyWay::DisplacementName, this->Kept->SourceVertex);
  const Eigen::VectorXd dentedBy = OfNodes(*body, vtkHapticBodyWay::DentName, this->Kept->SourceVertex);
  const vtkHapticBall ball = vtkHapticBallOn(*body);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  const auto moved = Vectors(vtkHapticBodyWay::DisplacementName, surface->GetNumberOfPoints());
  const auto dented = Vectors(vtkHapticBodyWay::DentName, surface->GetNumberOfPoints());
  const palpate::SurfaceMap& map = this->Kept->Embedding.map;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const auto point = static_cast<std::size_t>(i);
    const palpate::Vec3 gone_u = map.displacementOf(point, movedBy);
    const palpate::Vec3 moved_W = At(*surface->GetPoints(), i) + gone_u;
    const palpate::Vec3 place_W = vtkHapticOutOf(ball, moved_W + map.displacementOf(point, dentedBy));
    points->SetPoint(i, place_W.data());
    moved->SetTuple(i, gone_u.data());
    dented->SetTuple(i, palpate::Vec3(place_W - moved_W).data());
  }
  vtkPolyData* const skin = vtkPolyData::GetData(output);
  skin->ShallowCopy(surface);
  skin->SetPoints(points);
  skin->GetPointData()->SetNormals(nullptr); // of the surface at rest
  skin->GetPointData()->AddArray(moved);
  skin->GetPointData()->AddArray(dented);
  vtkNew<vtkIntArray> mark;
  mark->SetName(MarkName);
  mark->InsertNextValue(1);
  vtkNew<vtkFieldData> own;
  own->ShallowCopy(surface->GetFieldData());
  own->AddArray(mark);
  skin->SetFieldData(own);
  return 1;
}
