// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticViewScene.h"

#include "vtkHapticAskedField.h"
#include "vtkHapticColourRange.h"
#include "vtkHapticConversionAhead.h"
#include "vtkHapticDrafts.h"
#include "vtkHapticHandedSources.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkHapticNamedData.h"
#include "vtkHapticRemoteField.h"
#include "vtkHapticRemoteSurfaces.h"
#include "vtkHapticScanView.h"
#include "vtkHapticServerSurfaces.h"
#include "vtkHapticShapes.h"
#include "vtkHapticSight.h"
#include "vtkObjectFactory.h"
#include "vtkSMProxy.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkHapticViewScene);

namespace
{
constexpr const char* NothingShown = "No data are visible: open a file and press Apply.";

std::string Lines(const std::set<std::string>& names)
{
  std::string lines;
  for (const std::string& name : names)
  {
    lines += name + "\n";
  }
  return lines;
}
} // namespace

class vtkHapticViewScene::Internals
{
public:
  vtkWeakPointer<vtkSMProxy> View;
  vtkWeakPointer<vtkSMProxy> Drawing;
  vtkHapticDrafts Drafts;
  vtkHapticShapes Shapes;
  vtkHapticRemoteSurfaces Remote;
  vtkSmartPointer<vtkHapticSession> Session;
  vtkHapticViewScan Scan;
  vtkHapticHandedSources Handed;
  std::string Report;
  std::map<std::string, std::string> Rejected; ///< surfaces the session would not take, and why
  std::string FieldName;                       ///< of the source that is felt as a field; "": none
  vtkHapticFieldKey FieldKey;                  ///< its output then
  vtkMTimeType FieldSettings = 0;
  std::shared_ptr<const bool> FieldChanged;   ///< since then, on a server; null: it is not on one
  std::string FieldRefusal;                   ///< why none of those that have the arrays is
  std::string BesideRefusal;                  ///< which data beside the field are not there
  bool HandedOver = false;                    ///< the session has Scan
  std::optional<vtkHapticViewScan> Preparing; ///< a scan that is read by threads
  std::optional<vtkHapticViewScan> Left;      ///< shown when the reading was cancelled
  int Cancelled = 0;                          ///< how often the session had been told so then
  vtkMTimeType MaterialTime = 0;              ///< of the session's settings when it got Scan

  bool TouchesLines() const
  {
    return this->Session && (this->Session->GetSetting("LineRadius") > 0.0 || this->Session->GetRaisesLines());
  }

  bool TouchesPoints() const { return this->Session && this->Session->GetSetting("PointRadius") > 0.0; }

  /// At the shown data, curves as they were applied.
  vtkHapticViewScan Look() { return this->Look({ this->TouchesLines(), this->TouchesPoints() }); }

  /// Without the source that is in the hand.
  vtkHapticViewScan Look(vtkHapticScanOptions options)
  {
    options.Remote = &this->Remote;
    vtkHapticViewScan scan = vtkHapticScanView(this->View, this->Shapes, options);
    this->Handed.Change(this->Session, this->View, scan);
    return scan;
  }

  /// Whether the session can take a scan without holding the thread. If one of the same sources is being read it takes
  /// the place of this one: a series of pictures may come faster than they are read.
  bool IsPrepared(vtkHapticViewScan& scan);
  /// The data that are shown while the person cancels are left out.
  void FollowCancel(const vtkHapticViewScan& now);

  /// Gives the session the data that it names beside the field; "", or which of them is not there.
  std::string HandOverBeside();
  /// Gives the session the chosen source, or the first that has the arrays which are felt and fills space.
  void HandOverField(const std::vector<vtkHapticViewScan::Source>& sources);
  /// Gives it one; whether it is felt.
  bool HandOverField(const vtkHapticViewScan::Source& source);
  /// Whether a source has the arrays that are to be felt.
  bool CouldFeelField(const vtkHapticViewScan& scan) const;
  /// The refusals that stand: data that are felt as a field need no surface.
  std::vector<std::string> RefusalsOf(const vtkHapticViewScan& scan) const;

  /// Whether the session reads the same materials from the surfaces' arrays as from those of Scan.
  bool SameMaterials(const vtkHapticViewScan& now) const
  {
    return !this->Session || (this->Session->GetSight()->GetMaterialTime() == this->MaterialTime &&
                               (!this->Session->GetSight()->GetUsesMaterialArrays() || now.SameArraysAs(this->Scan)));
  }
};

namespace
{
/// That stays as it is when the pipeline goes on.
vtkHapticViewScan SharedCopy(vtkHapticViewScan scan)
{
  for (vtkHapticViewScan::Surface& surface : scan.Surfaces)
  {
    surface.Data = vtkHapticSharedCopy(surface.Data);
  }
  return scan;
}

} // namespace

bool vtkHapticViewScene::Internals::CouldFeelField(const vtkHapticViewScan& scan) const
{
  return this->Session && !vtkHapticCandidatesOfField(*this->Session, this->View, scan.Sources).Sources.empty();
}

std::string vtkHapticViewScene::Internals::HandOverBeside()
{
  std::string missing;
  const auto named = [&](const std::string& name)
  {
    vtkDataObject* const data = name.empty() ? nullptr : vtkHapticNamedData(this->View, name);
    missing = data || name.empty() ? missing : name + ": no source with data has this name";
    return data;
  };
  vtkDataObject* const compared = named(this->Session->GetSettingText("CompareSource"));
  this->Session->GetSight()->SetComparedField(compared, named(this->Session->GetSettingText("SnapSource")));
  return missing;
}

void vtkHapticViewScene::Internals::HandOverField(const std::vector<vtkHapticViewScan::Source>& sources)
{
  this->BesideRefusal = vtkHapticAsksForField(*this->Session) ? this->HandOverBeside() : "";
  const vtkHapticFieldCandidates candidates = vtkHapticCandidatesOfField(*this->Session, this->View, sources);
  const vtkHapticViewScan::Source* const first = candidates.Sources.empty() ? nullptr : &candidates.Sources.front();
  const vtkHapticFieldKey key = first ? vtkHapticKeyOfField(*first, this->View) : vtkHapticFieldKey();
  const bool changed = this->FieldChanged && *this->FieldChanged;
  if (key == this->FieldKey && !changed && this->FieldSettings == this->Session->GetSight()->GetMaterialTime())
  {
    return;
  }
  this->FieldKey = key;
  this->FieldChanged.reset();
  this->FieldSettings = this->Session->GetSight()->GetMaterialTime();
  this->FieldName.clear();
  this->FieldRefusal = candidates.Refusal;
  for (const vtkHapticViewScan::Source& source : candidates.Sources)
  {
    if (this->HandOverField(source))
    {
      this->FieldName = source.Name;
      return;
    }
    this->FieldRefusal = this->Session->GetProblem();
  }
  if (!first)
  {
    this->Session->AddField(nullptr, nullptr);
  }
}

bool vtkHapticViewScene::Internals::HandOverField(const vtkHapticViewScan::Source& source)
{
  if (source.Data)
  {
    return this->Session->AddField(source.Name.c_str(), source.Data);
  }
  const vtkHapticRemoteFieldResult remote =
    vtkHapticRemoteField(source.Remote, source.Port, this->FieldKey.Time, vtkHapticArraysOfSession(*this->Session));
  this->FieldChanged = remote.Changed;
  return this->Session->GetSight()->AddRemoteField(source.Name.c_str(), remote.Field);
}

bool vtkHapticViewScene::Internals::IsPrepared(vtkHapticViewScan& scan)
{
  if (this->Preparing && this->Preparing->SameNamesAs(scan))
  {
    scan = *this->Preparing;
  }
  bool ready = true;
  for (const vtkHapticViewScan::Surface& surface : scan.Surfaces)
  {
    ready = this->Session->GetSight()->PrepareSurface(surface.Name.c_str(), surface.Data, surface.Matrix) && ready;
  }
  this->Preparing = ready ? std::nullopt : std::optional(SharedCopy(scan));
  return ready;
}

void vtkHapticViewScene::Internals::FollowCancel(const vtkHapticViewScan& now)
{
  const int cancelled = this->Session->GetSight()->GetScenesCancelled();
  if (std::exchange(this->Cancelled, cancelled) != cancelled)
  {
    this->Preparing.reset();
    this->Left = now;
  }
}

std::vector<std::string> vtkHapticViewScene::Internals::RefusalsOf(const vtkHapticViewScan& scan) const
{
  std::vector<std::string> refusals;
  for (const std::string& refusal : scan.Refusals)
  {
    if (this->FieldName.empty() || !refusal.starts_with(this->FieldName + ": "))
    {
      refusals.push_back(refusal);
    }
  }
  for (const std::string& refusal : { this->FieldRefusal, this->BesideRefusal })
  {
    if (!refusal.empty())
    {
      refusals.push_back(refusal + ".");
    }
  }
  return refusals;
}

std::string vtkHapticViewScene::TakeColorRange(vtkSMProxy* session)
{
  return vtkHapticTakeColourRange(this->Impl->View, session);
}

vtkHapticViewScene::vtkHapticViewScene() : Impl(std::make_unique<Internals>()) {}

vtkHapticViewScene::~vtkHapticViewScene() = default;

void vtkHapticViewScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->GetView() << "\n";
  os << indent << "Drawing: " << this->GetDrawing() << "\n";
  os << indent << "Session: " << this->GetSession() << "\n";
  os << indent << "ReadsAhead: " << this->ReadsAhead << "\n";
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
    this->Impl->Cancelled = session ? session->GetSight()->GetScenesCancelled() : 0;
    this->Impl->Drafts.ForgetAll();
    this->Impl->HandedOver = false;
    this->Impl->Handed.Forget();
    this->Impl->Preparing.reset(); // the session before began with it
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
  return Lines(names);
}

std::string vtkHapticViewScene::GetRefusal() const
{
  const vtkHapticViewScan now = this->Impl->Look();
  const bool holds = this->Impl->Session && *this->Impl->Session->GetSettingText("MechanismSource") != '\0';
  if (!now.Surfaces.empty() || now.Pending || holds || this->Impl->CouldFeelField(now))
  {
    return {};
  }
  return now.Refusals.empty() ? NothingShown : now.Refusals.front();
}

std::string vtkHapticViewScene::GetFieldNames(int components) const
{
  std::set<std::string> names;
  const std::vector<vtkHapticViewScan::Source> shown = this->Impl->Look().Sources;
  for (const vtkHapticViewScan::Source& source :
    this->Impl->Session ? vtkHapticSourcesOfField(*this->Impl->Session, this->Impl->View, shown) : shown)
  {
    const std::vector<std::string> found = vtkHapticArraysOfSource(source, components);
    names.insert(found.begin(), found.end());
  }
  return Lines(names);
}

const char* vtkHapticViewScene::GetReport() const
{
  return this->Impl->Report.c_str();
}

void vtkHapticViewScene::TakeAgain()
{
  const int cancelled = this->Impl->Session ? this->Impl->Session->GetSight()->GetScenesCancelled() : 0;
  this->Impl->HandedOver = this->Impl->HandedOver && !this->Impl->Left && this->Impl->Cancelled == cancelled;
  this->Impl->Cancelled = cancelled;
  this->Impl->Left.reset();
}

bool vtkHapticViewScene::Update()
{
  this->Impl->Remote.Follow(this->Impl->View, this->Impl->Session);
  vtkHapticViewScan now = this->Impl->Look(
    { this->Impl->TouchesLines(), this->Impl->TouchesPoints(), &this->Impl->Drafts, nullptr, this->Impl->Drawing });
  this->Impl->Shapes.Forget();
  const bool same = this->Impl->HandedOver && now.SameAs(this->Impl->Scan) && this->Impl->SameMaterials(now);
  if (this->Impl->Session)
  {
    this->Impl->FollowCancel(now);
  }
  const bool left = this->Impl->Left && now.SameAs(*this->Impl->Left);
  const bool differs = !same && this->Impl->Session && !left;
  const bool handOver = differs && (!this->ReadsAhead || this->Impl->IsPrepared(now));
  if (!differs && this->Impl->Preparing) // the data that were being read are hidden again
  {
    this->Impl->Preparing.reset();
    this->Impl->Session->GetSight()->ForgetPrepared();
  }
  if (handOver || !differs)
  {
    this->Impl->Scan = std::move(now);
  }
  if (handOver)
  {
    this->Impl->Left.reset();
    this->HandOver();
    this->Impl->HandedOver = true;
    this->Impl->MaterialTime = this->Impl->Session->GetSight()->GetMaterialTime();
  }
  if (this->Impl->Session)
  {
    this->Impl->HandOverField(this->Impl->Scan.Sources);
  }
  this->ShowHanded();
  this->WriteReport();
  return handOver;
}

void vtkHapticViewScene::ShowHanded()
{
  if (this->Impl->Session)
  {
    this->Impl->Handed.Follow(*this->Impl->Session, this->Impl->View);
  }
}

void vtkHapticViewScene::HandOver()
{
  vtkHapticSession* session = this->Impl->Session;
  this->Impl->Rejected.clear();
  session->ClearSurfaces();
  for (const vtkHapticViewScan::Surface& surface : this->Impl->Scan.Surfaces)
  {
    session->GetSight()->ServerSurfaces().SetPartNumber(surface.Part);
    if (!session->AddSurface(surface.Name.c_str(), surface.Data, surface.Matrix))
    {
      this->Impl->Rejected[surface.Name] = session->GetProblem();
    }
  }
  this->Impl->Remote.Tell(*session);
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
  for (const vtkHapticViewScan::Surface& surface : this->Impl->Preparing.value_or(vtkHapticViewScan()).Surfaces)
  {
    report += "Reading " + surface.Name + ".\n";
  }
  if (!this->Impl->FieldName.empty())
  {
    report += "Feeling " + std::string(this->Impl->Session->GetFieldText()) + ".\n";
  }
  for (const std::string& refusal : this->Impl->RefusalsOf(this->Impl->Scan))
  {
    report += "Not touched: " + refusal + "\n";
  }
  if (report.empty())
  {
    report = this->Impl->Scan.Pending ? "Waiting for the first frame.\n" : std::string(NothingShown) + "\n";
  }
  this->Impl->Report = std::move(report);
}
