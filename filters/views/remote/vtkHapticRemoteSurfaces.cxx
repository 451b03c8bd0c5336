// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticRemoteSurfaces.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <Eigen/Eigenvalues>

#include "haptics/core/WordHash.h"
#include "haptics/geometry/tree/BoxTree.h"
#include "vtkBoundingBox.h"
#include "vtkGeometryRepresentation.h"
#include "vtkHapticNamedData.h"
#include "vtkHapticServerSurfaces.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkHapticSurfacePlacement.h"
#include "vtkMatrix4x4.h"
#include "vtkPVDataInformation.h"
#include "vtkPVLODActor.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

namespace
{
/// The least that a direction is stretched by.
double LeastStretch(const vtkHapticPlacement& placement)
{
  const Eigen::Matrix3d squared = placement.linear().transpose() * placement.linear();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> stretches(squared, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, stretches.eigenvalues()[0]));
}

void Include(palpate::Box& box, const std::array<double, 6>& bounds, const vtkHapticPlacement& placement)
{
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const palpate::Vec3 at(bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + ((corner >> 2) & 1)]);
    box.include(placement * at);
  }
}

std::string Describe(const vtkHapticPartInfo& info, vtkIdType cells)
{
  std::ostringstream text;
  if (info.Whole)
  {
    text << "all of its " << info.CellsOfAll << " polygons";
    return text.str();
  }
  text << cells << " of its " << info.CellsOfAll << " polygons, " << info.Reach << " u around the hand";
  return text.str();
}
} // namespace

bool vtkHapticRemoteSurfaces::Fetches(vtkObject* active)
{
  return active && active->IsA("vtkGeometryRepresentation") && !active->IsA("vtkGlyph3DRepresentation") &&
         !active->IsA("vtkOutlineRepresentation") && !active->IsA("vtkFeatureEdgesRepresentation");
}

void vtkHapticRemoteSurfaces::Add(
  vtkSMProxy* representation, vtkHapticSession& session, std::map<vtkSMProxy*, Shown>& before)
{
  auto* const geometry = vtkGeometryRepresentation::SafeDownCast(vtkHapticActiveRepresentation(representation));
  const vtkHapticViewScan::Source source =
    vtkHapticShownSource(representation, vtkHapticNameOf(vtkHapticInputOf(representation)));
  const bool inHand =
    source.Name == session.GetSettingText("MechanismSource") || source.Name == session.GetSettingText("ToolSource");
  if (!source.Remote || source.Name.empty() || inHand || !Fetches(geometry))
  {
    return;
  }
  if (auto known = before.extract(representation))
  {
    this->All.insert(std::move(known));
  }
  Shown& shown = this->All[representation];
  shown.Name = source.Name;
  shown.Matrix = geometry->GetActor()->GetMatrix();
  if (!shown.Surface || shown.Surface->GetSource() != source.Remote || shown.Surface->GetPort() != source.Port)
  {
    shown.Surface = std::make_unique<vtkHapticRemoteSurface>(source.Remote, source.Port);
  }
}

void vtkHapticRemoteSurfaces::Keep(vtkSMProxy* view, vtkHapticSession& session)
{
  std::map<vtkSMProxy*, Shown> before = std::move(this->All);
  this->All.clear();
  for (vtkSMProxy* const representation : vtkHapticVisibleRepresentations(view))
  {
    this->Add(representation, session, before);
  }
}

vtkHapticPartWish vtkHapticRemoteSurfaces::WishOf(const Shown& shown, vtkSMProxy* view, vtkHapticSession& session)
{
  const vtkHapticServerSurfaces& server = session.GetSight()->ServerSurfaces();
  const vtkHapticPlacement placement = vtkHapticPlacementOf(shown.Matrix);
  vtkHapticPartWish wish;
  if (const std::optional<palpate::Vec3> hand_W = server.GetCentre())
  {
    wish.Centre = placement.inverse() * *hand_W;
  }
  else
  {
    vtkSMSourceProxy* const source = shown.Surface->GetSource();
    vtkBoundingBox(source->GetDataInformation(shown.Surface->GetPort())->GetBounds()).GetCenter(wish.Centre.data());
  }
  wish.Reach = server.GetReach() / LeastStretch(placement);
  wish.Limit = server.GetLimit();
  wish.Time = vtkSMPropertyHelper(view, "ViewTime").GetAsDouble();
  return wish;
}

void vtkHapticRemoteSurfaces::Follow(vtkSMProxy* view, vtkHapticSession* session)
{
  if (!view || !session || !vtkHapticIsRemote(view))
  {
    this->All.clear();
    return;
  }
  this->Keep(view, *session);
  std::vector<std::pair<vtkHapticRemoteSurface*, vtkHapticPartWish>> wishes;
  bool again = session->GetSight()->ServerSurfaces().NeedsPart();
  for (const auto& [representation, shown] : this->All)
  {
    if (vtkHapticCheckPlacement(shown.Matrix).empty())
    {
      wishes.emplace_back(shown.Surface.get(), WishOf(shown, view, *session));
      again = again || shown.Surface->IsStale(wishes.back().second);
    }
  }
  if (!again)
  {
    return;
  }
  session->GetSight()->ServerSurfaces().BeginRequest();
  for (const auto& [surface, wish] : wishes) // parts are all around one place
  {
    if (surface->IsStale(wish) || (surface->GetData() && !surface->GetInfo().Whole))
    {
      surface->Ask(wish);
    }
  }
  session->GetSight()->ServerSurfaces().EndRequest();
}

void vtkHapticRemoteSurfaces::Tell(vtkHapticSession& session) const
{
  constexpr double most = std::numeric_limits<double>::max();
  palpate::Box bounds{ palpate::Vec3::Constant(most), palpate::Vec3::Constant(-most) };
  palpate::ScenePart part;
  palpate::WordHash whole;
  std::string sentence;
  bool any = false;
  for (const auto& [representation, shown] : this->All)
  {
    const vtkHapticRemoteSurface& surface = *shown.Surface;
    if (!surface.GetData())
    {
      continue;
    }
    const vtkHapticPartInfo& info = surface.GetInfo();
    const vtkHapticPlacement placement = vtkHapticPlacementOf(shown.Matrix);
    sentence += (sentence.empty() ? "" : "; ") + shown.Name + ": " +
                Describe(info, surface.GetData()->GetNumberOfPolys() + surface.GetData()->GetNumberOfStrips());
    Include(bounds, info.Bounds, placement);
    whole.add(reinterpret_cast<std::uintptr_t>(surface.GetSource()));
    whole.add(static_cast<std::uint64_t>(surface.GetChanges()));
    if (info.Whole)
    {
      continue;
    }
    const palpate::Vec3 centre_W = placement * palpate::Vec3(info.Centre.data());
    part.centre_W = any ? part.centre_W : centre_W;
    const double reach_u = info.Reach * LeastStretch(placement) - (centre_W - part.centre_W).norm();
    part.reach_u = any ? std::min(part.reach_u, reach_u) : reach_u;
    any = true;
  }
  part.whole = any ? whole.value() : 0;
  part.reach_u = std::max(0.0, part.reach_u);
  part.bounds_W = { bounds.low_W.x(), bounds.high_W.x(), bounds.low_W.y(), bounds.high_W.y(), bounds.low_W.z(),
    bounds.high_W.z() };
  session.GetSight()->ServerSurfaces().Take(part, sentence);
}

vtkHapticShape vtkHapticRemoteSurfaces::ShapeOf(vtkSMProxy* representation) const
{
  const auto found = this->All.find(representation);
  return found == this->All.end()
           ? vtkHapticShape()
           : vtkHapticShape{ found->second.Surface->GetData(), found->second.Surface->GetProblem() };
}

int vtkHapticRemoteSurfaces::PartOf(vtkSMProxy* representation) const
{
  const auto found = this->All.find(representation);
  return found == this->All.end() || found->second.Surface->GetInfo().Whole ? 0
                                                                            : found->second.Surface->GetInfo().Number;
}
