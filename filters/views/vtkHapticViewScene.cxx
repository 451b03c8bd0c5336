// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticViewScene.h"

#include "vtkHapticDrafts.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticSession.h"
#include "vtkHapticShapes.h"
#include "vtkHapticViewScan.h"
#include "vtkObjectFactory.h"
#include "vtkSMProxy.h"
#include "vtkWeakPointer.h"

#include <map>
#include <set>
#include <string>

vtkStandardNewMacro(vtkHapticViewScene);

namespace
{
constexpr const char* NothingShown = "Nothing is shown: open a file and press Apply.";
} // namespace

class vtkHapticViewScene::Internals
{
public:
  vtkWeakPointer<vtkSMProxy> View;
  vtkWeakPointer<vtkSMProxy> Drawing;
  vtkHapticDrafts Drafts;
  vtkHapticShapes Shapes;
  vtkSmartPointer<vtkHapticSession> Session;
  vtkHapticViewScan Scan;
  std::string Report;
  std::map<std::string, std::string> Rejected; ///< surfaces the session would not take, and why
  bool HandedOver = false;                     ///< the session has Scan
  vtkMTimeType MaterialTime = 0;               ///< of the session's settings when it got Scan

  bool TouchesLines() const
  {
    return this->Session && (this->Session->GetLineRadius() > 0.0 || this->Session->GetRaisesLines());
  }

  bool TouchesPoints() const { return this->Session && this->Session->GetPointRadius() > 0.0; }

  /// At what is shown, curves as they were applied.
  vtkHapticViewScan Look()
  {
    return vtkHapticScanView(this->View, this->Shapes, { this->TouchesLines(), this->TouchesPoints() });
  }

  /// What the session makes of the surfaces' arrays is what it made of those of Scan.
  bool SameMaterials(const vtkHapticViewScan& now) const
  {
    return !this->Session || (this->Session->GetMaterialTime() == this->MaterialTime &&
                               (!this->Session->GetUsesMaterialArrays() || now.SameArraysAs(this->Scan)));
  }
};

vtkHapticViewScene::vtkHapticViewScene() : Impl(std::make_unique<Internals>()) {}

vtkHapticViewScene::~vtkHapticViewScene() = default;

void vtkHapticViewScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->GetView() << "\n";
  os << indent << "Drawing: " << this->GetDrawing() << "\n";
  os << indent << "Session: " << this->GetSession() << "\n";
  os << indent << "NumberOfSurfaces: " << this->GetNumberOfSurfaces() << "\n";
  os << indent << "Report: " << this->Impl->Report << "\n";
}

void vtkHapticViewScene::SetView(vtkSMProxy* view)
{
  if (view != this->Impl->View)
  {
    this->Impl->View = view;
    this->Impl->Drafts.ForgetAll();
    this->Modified();
  }
}

void vtkHapticViewScene::SetDrawing(vtkSMProxy* source)
{
  if (source != this->Impl->Drawing)
  {
    this->Impl->Drawing = source;
    this->Modified();
  }
}

vtkSMProxy* vtkHapticViewScene::GetDrawing() const
{
  return this->Impl->Drawing;
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
    this->Impl->Drafts.ForgetAll();
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

std::string vtkHapticViewScene::GetArrayNames() const
{
  std::set<std::string> names;
  const vtkHapticViewScan now = this->Impl->Look();
  for (const vtkHapticViewScan::Surface& surface : now.Surfaces)
  {
    for (const std::string& name : vtkHapticArrayNames(surface.Data))
    {
      names.insert(name);
    }
  }
  std::string lines;
  for (const std::string& name : names)
  {
    lines += name + "\n";
  }
  return lines;
}

std::string vtkHapticViewScene::GetRefusal() const
{
  const vtkHapticViewScan now = this->Impl->Look();
  if (!now.Surfaces.empty() || now.Pending)
  {
    return {};
  }
  return now.Refusals.empty() ? NothingShown : now.Refusals.front();
}

const char* vtkHapticViewScene::GetReport() const
{
  return this->Impl->Report.c_str();
}

bool vtkHapticViewScene::Update()
{
  vtkHapticViewScan now = vtkHapticScanView(this->Impl->View, this->Impl->Shapes,
    { this->Impl->TouchesLines(), this->Impl->TouchesPoints(), &this->Impl->Drafts, this->Impl->Drawing });
  this->Impl->Shapes.Forget();
  const bool same = this->Impl->HandedOver && now.SameAs(this->Impl->Scan) && this->Impl->SameMaterials(now);
  this->Impl->Scan = std::move(now);
  const bool handOver = !same && this->Impl->Session;
  if (handOver)
  {
    this->HandOver();
    this->Impl->HandedOver = true;
    this->Impl->MaterialTime = this->Impl->Session->GetMaterialTime();
  }
  this->WriteReport();
  return handOver;
}

void vtkHapticViewScene::HandOver()
{
  vtkHapticSession* session = this->Impl->Session;
  this->Impl->Rejected.clear();
  session->ClearSurfaces();
  for (const vtkHapticViewScan::Surface& surface : this->Impl->Scan.Surfaces)
  {
    if (!session->AddSurface(surface.Name.c_str(), surface.Data, surface.Matrix))
    {
      this->Impl->Rejected[surface.Name] = session->GetProblem();
    }
  }
  session->CommitScene();
}

void vtkHapticViewScene::WriteReport()
{
  std::string report;
  for (const vtkHapticViewScan::Surface& surface : this->Impl->Scan.Surfaces)
  {
    const auto rejected = this->Impl->Rejected.find(surface.Name);
    report += rejected == this->Impl->Rejected.end() ? "Touching " + surface.Name + ".\n"
                                                     : "Not touched: " + rejected->second + "\n";
  }
  for (const std::string& refusal : this->Impl->Scan.Refusals)
  {
    report += "Not touched: " + refusal + "\n";
  }
  if (report.empty())
  {
    report = this->Impl->Scan.Pending ? "Waiting for the first picture.\n" : std::string(NothingShown) + "\n";
  }
  this->Impl->Report = std::move(report);
}
