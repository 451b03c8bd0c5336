// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHandedSource_h
#define vtkHapticHandedSource_h

#include "vtkDataObject.h"
#include "vtkHapticSession.h"
#include "vtkHapticViewScan.h"
#include "vtkSmartPointer.h"

#include <string>
#include <utility>

class vtkSMProxy;

/// Keeps one kind of felt thing in step with a source of the pipeline that a setting names. A kind brings the data,
/// tells the session, and shows where the session has them.
class vtkHapticHandedSource
{
public:
  virtual ~vtkHapticHandedSource() = default;

  /// Tells the session of other data, or that the source is gone. `view`: of the pipeline.
  virtual void Follow(vtkHapticSession& session, vtkSMProxy* view) = 0;
  /// The next look tells it in any case.
  void Forget() { this->Known = false; }
  /// The part of it that is touched as a surface: none.
  virtual void Change(vtkHapticSession* session, vtkSMProxy* /*view*/, vtkHapticViewScan& scan)
  {
    scan.LeaveOut(this->NameIn(session));
  }

protected:
  explicit vtkHapticHandedSource(const char* setting) : Setting(setting) {}

  std::string NameIn(vtkHapticSession* session) const { return session ? session->GetSettingText(this->Setting) : ""; }
  /// Whether the session is to be told of these.
  bool AreOthers(const std::string& name, vtkDataObject* data, vtkMTimeType time = 0, const std::string& reason = "")
  {
    const bool same = this->Known && name == this->Name && data == this->Data && time == this->Time;
    const bool all = same && reason == this->Reason;
    this->Known = true;
    this->Name = name;
    this->Data = data;
    this->Time = time;
    this->Reason = reason;
    return !all;
  }

  std::string Name;                    ///< of the source that the session was told of
  vtkSmartPointer<vtkDataObject> Data; ///< that it has

private:
  const char* Setting;
  bool Known = false;
  vtkMTimeType Time = 0;
  std::string Reason; ///< why there are no data
};

#endif
