// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPencilGround.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkHapticConversion.h"
#include "vtkHapticScanView.h"
#include "vtkHapticShapes.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using palpate::Vec3;

namespace
{
constexpr double edgeOn = 1e-3; ///< of the ray's length, as far as it goes across the plane

Vec3 Unprojected(vtkRenderer* renderer, double x, double y, double z)
{
  double p[4];
  renderer->SetDisplayPoint(x, y, z);
  renderer->DisplayToWorld();
  renderer->GetWorldPoint(p);
  return Vec3(Vec3(p) / p[3]);
}

std::optional<Vec3> OnPlane(vtkRenderer* renderer, double x, double y, const Vec3& origin_W, const Vec3& normal_W)
{
  const Vec3 near_W = Unprojected(renderer, x, y, 0.0);
  const Vec3 ray = Unprojected(renderer, x, y, 1.0) - near_W;
  const double across = normal_W.dot(ray);
  const double share = normal_W.dot(origin_W - near_W) / across;
  if (std::fabs(across) < edgeOn * ray.norm() || !(share >= 0.0))
  {
    return std::nullopt;
  }
  Vec3 p_W = near_W + share * ray;
  for (int k = 0; k < 3; ++k)
  {
    // A plane across an axis is met to the bit: curves drawn at one height lie at one height.
    p_W[k] = std::fabs(normal_W[k]) == 1.0 ? origin_W[k] : p_W[k];
  }
  return p_W;
}

vtkSmartPointer<vtkStaticCellLocator> TreeOf(vtkPolyData& shown)
{
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(shown.GetPoints());
  polygons->SetPolys(shown.GetPolys());
  polygons->SetStrips(shown.GetStrips());
  auto tree = vtkSmartPointer<vtkStaticCellLocator>::New();
  tree->SetDataSet(polygons);
  tree->BuildLocator();
  return tree;
}

Vec3 In(vtkMatrix4x4* frame, const Vec3& p_W)
{
  double p[4] = { p_W.x(), p_W.y(), p_W.z(), 1.0 };
  frame->MultiplyPoint(p, p);
  return Vec3(p) / p[3];
}
} // namespace

vtkHapticPencilGround vtkHapticPlaneGround(vtkRenderer* renderer, const Vec3& point_W, const Vec3& normal_W)
{
  return [=](double x, double y) { return OnPlane(renderer, x, y, point_W, normal_W); };
}

vtkHapticPencilGround vtkHapticScreenGround(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  return vtkHapticPlaneGround(renderer, Vec3(camera->GetFocalPoint()), Vec3(camera->GetDirectionOfProjection()));
}

/// Polygons of one actor, in its frame.
struct vtkHapticSurfaceGround::Piece
{
  vtkSmartPointer<vtkStaticCellLocator> Tree;
  vtkSmartPointer<vtkMatrix4x4> FromWorld;

  /// As a share of the segment from one point to another, where that first meets a polygon; none where it does not.
  [[nodiscard]] std::optional<double> FirstOn(const Vec3& from_W, const Vec3& to_W) const
  {
    const Vec3 from = In(this->FromWorld, from_W), to = In(this->FromWorld, to_W);
    constexpr double rounding = 1e-9; // of the size: no ray slips through between two polygons
    const double tolerance = rounding * this->Tree->GetDataSet()->GetLength();
    double share = 0.0, at[3], inCell[3];
    int part = 0;
    vtkIdType cell = -1;
    const bool met =
      this->Tree->IntersectWithLine(from.data(), to.data(), tolerance, share, at, inCell, part, cell) != 0;
    return met ? std::optional(share) : std::nullopt;
  }

  static std::vector<Piece> Of(const vtkHapticViewScan& scan)
  {
    std::vector<Piece> pieces;
    for (const vtkHapticViewScan::Surface& surface : scan.Surfaces)
    {
      auto fromWorld = vtkSmartPointer<vtkMatrix4x4>::New();
      vtkMatrix4x4::Invert(surface.Matrix, fromWorld);
      vtkHapticForEachDataSet(surface.Data,
        [&](vtkDataSet& set)
        {
          auto* const shown = vtkPolyData::SafeDownCast(&set);
          if (shown && shown->GetNumberOfPolys() + shown->GetNumberOfStrips() > 0)
          {
            pieces.push_back({ TreeOf(*shown), fromWorld });
          }
        });
    }
    return pieces;
  }
};

vtkHapticPencilGround vtkHapticSurfaceGround::At(vtkSMRenderViewProxy* view, double x, double y)
{
  vtkHapticShapes shapes;
  vtkHapticViewScan now = vtkHapticScanView(view, shapes);
  if (!this->Pieces || !now.SameAs(this->Scan))
  {
    this->Pieces = std::make_shared<const std::vector<Piece>>(Piece::Of(now));
    this->Scan = std::move(now);
  }
  const vtkHapticPencilGround ground = [pieces = this->Pieces, renderer = view->GetRenderer()](
                                         double atX, double atY) -> std::optional<Vec3>
  {
    const Vec3 near_W = Unprojected(renderer, atX, atY, 0.0), far_W = Unprojected(renderer, atX, atY, 1.0);
    std::optional<double> first;
    for (const Piece& piece : *pieces)
    {
      const std::optional<double> share = piece.FirstOn(near_W, far_W);
      first = share ? std::min(*share, first.value_or(*share)) : first;
    }
    return first ? std::optional(Vec3(near_W + *first * (far_W - near_W))) : std::nullopt;
  };
  return ground(x, y) ? ground : nullptr;
}
