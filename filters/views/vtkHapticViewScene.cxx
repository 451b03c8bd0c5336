// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticViewScene.h"

#include "vtkHapticSession.h"
#include "vtkHapticViewScan.h"
#include "vtkObjectFactory.h"
#include "vtkSMProxy.h"
#include "vtkWeakPointer.h"

vtkStandardNewMacro(vtkHapticViewScene);

class vtkHapticViewScene::Internals
{
public:
  vtkWeakPointer<vtkSMProxy> View;
  vtkSmartPointer<vtkHapticSession> Session;
  vtkHapticViewScan Scan;
  std::string Report;
  std::vector<std::string> Rejected; ///< what the session would not take, until the next hand-over
  bool HandedOver = false;           ///< the session has Scan
};

vtkHapticViewScene::vtkHapticViewScene() : Impl(std::make_unique<Internals>()) {}

vtkHapticViewScene::~vtkHapticViewScene() = default;

void vtkHapticViewScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->GetView() << "\n";
  os << indent << "Session: " << this->GetSession() << "\n";
  os << indent << "NumberOfSurfaces: " << this->GetNumberOfSurfaces() << "\n";
  os << indent << "Report: " << this->Impl->Report << "\n";
}

void vtkHapticViewScene::SetView(vtkSMProxy* view)
{
  if (view != this->Impl->View)
  {
    this->Impl->View = view;
    this->Modified();
  }
}

vtkSMProxy* vtkHapticViewScene::GetView() const
{
  return this->Impl->View;
}

void vtkHapticViewScene::SetSession(vtkHapticSession* session)
{
  if (session != this->Impl->Session)
  {
    this->Impl->Session = session;
    this->Impl->HandedOver = false;
    this->Modified();
  }
}

vtkHapticSession* vtkHapticViewScene::GetSession() const
{
  return this->Impl->Session;
}

int vtkHapticViewScene::GetNumberOfSurfaces() const
{
  return static_cast<int>(this->Impl->Scan.Surfaces.size());
}

const char* vtkHapticViewScene::GetReport() const
{
  return this->Impl->Report.c_str();
}

bool vtkHapticViewScene::Update()
{
  vtkHapticViewScan now = vtkHapticScanView(this->Impl->View);
  const bool same = this->Impl->HandedOver && now.SameAs(this->Impl->Scan);
  this->Impl->Scan = std::move(now);
  const bool handOver = !same && this->Impl->Session;
  if (handOver)
  {
    this->HandOver();
    this->Impl->HandedOver = true;
  }
  this->WriteReport();
  return handOver;
}

void vtkHapticViewScene::HandOver() {}

void vtkHapticViewScene::WriteReport()
{
  std::string report;
  for (const vtkHapticViewScan::Surface& surface : this->Impl->Scan.Surfaces)
  {
    report += "Touching " + surface.Name + ".\n";
  }
  for (const auto* refusals : { &this->Impl->Scan.Refusals, &this->Impl->Rejected })
  {
    for (const std::string& refusal : *refusals)
    {
      report += "Not touched: " + refusal + "\n";
    }
  }
  if (report.empty())
  {
    report = this->Impl->Scan.Pending ? "Waiting for the first picture.\n"
                                      : "Nothing is shown: open a file and press Apply.\n";
  }
  this->Impl->Report = std::move(report);
}
