// SPDX-License-Identifier: GPL-3.0-or-later
// Where a program holds the hand, and the stroke that a simulated one makes.
#include "vtkCellArray.h"
#include "vtkHapticSessionInternals.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

void vtkHapticSession::Internals::FeedTo(palpate::FedDevice& fed, bool placed) const
{
  if (this->Hand_W)
  {
    palpate::DeviceSample sample;
    const palpate::WorkspaceMap& map = this->Asked.asked().map;
    sample.pose_D = { map.toDevice(*this->Hand_W), map.q_WD.conjugate() * this->HandTurn_W };
    placed ? fed.place(sample) : fed.feed(sample);
  }
}

void vtkHapticSession::Internals::Feed(bool placed)
{
  if (auto* fed = dynamic_cast<palpate::FedDevice*>(this->Core.device()))
  {
    this->FeedTo(*fed, placed);
  }
}

void vtkHapticSession::Internals::Withdraw()
{
  if (auto* fed = dynamic_cast<palpate::FedDevice*>(this->Core.device()))
  {
    fed->withdraw();
  }
}

void vtkHapticSession::SetHandPosition(double x, double y, double z)
{
  this->Impl->Hand_W = palpate::Vec3(x, y, z);
  this->Impl->Feed();
}

void vtkHapticSession::SetHandPosition(const double p_W[3])
{
  this->SetHandPosition(p_W[0], p_W[1], p_W[2]);
}

void vtkHapticSession::SetStrokePath(vtkPolyData* path)
{
  if (!path || path->GetNumberOfLines() != 1)
  {
    this->Impl->Refuse("a stroke must be poly data with one polyline");
    return;
  }
  vtkNew<vtkIdList> ids;
  path->GetLines()->GetCellAtId(0, ids);
  this->Impl->Stroke_W.clear();
  for (vtkIdType id : *ids)
  {
    this->AddStrokePoint(path->GetPoint(id)[0], path->GetPoint(id)[1], path->GetPoint(id)[2]);
  }
}

void vtkHapticSession::ClearStrokePoints()
{
  this->Impl->Stroke_W.clear();
  this->Modified();
}

void vtkHapticSession::AddStrokePoint(double x, double y, double z)
{
  this->Impl->Stroke_W.emplace_back(x, y, z);
  this->Modified();
}

int vtkHapticSession::GetNumberOfStrokePoints() const
{
  return static_cast<int>(this->Impl->Stroke_W.size());
}
