// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticRecordings.h"

#include "pqCoreUtilities.h"
#include "pqFileDialog.h"
#include "pqHapticCommand.h"
#include "pqLoadDataReaction.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QAction>
#include <QStringList>

#include <cstring>
#include <utility>

namespace
{
/// "" when the person thinks better of it.
QString AskForFile(const char* name, const QString& title, pqFileDialog::FileMode mode)
{
  pqFileDialog dialog(nullptr, pqCoreUtilities::mainWidget(), title, QString(),
    pqHapticRecordings::tr("Recordings of touching (*.palpate)"), false);
  dialog.setObjectName(name);
  dialog.setFileMode(mode);
  return dialog.exec() == QDialog::Accepted ? dialog.getSelectedFiles().value(0) : QString();
}
} // namespace

pqHapticRecordings::pqHapticRecordings(QObject* parent) : Superclass(parent), RecordAction(new QAction(this))
{
  this->RecordAction->setText(tr("Record"));
  this->RecordAction->setObjectName("hapticRecordAction");
  this->RecordAction->setCheckable(true);
  this->RecordAction->setEnabled(false);
  this->RecordAction->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R));
  this->RecordAction->setToolTip(tr("Record the touch, from now on or from the next touch"));
  this->connect(this->RecordAction, &QAction::toggled, this, &pqHapticRecordings::record);
}

pqHapticRecordings::~pqHapticRecordings() = default;

void pqHapticRecordings::setProxy(vtkSMProxy* proxy)
{
  this->Proxy = proxy;
  this->Before.clear();
  this->Awaited = false;
  this->follow();
}

void pqHapticRecordings::follow()
{
  this->RecordAction->setEnabled(this->Proxy != nullptr);
  const bool records = this->Proxy && vtkSMPropertyHelper(this->Proxy, "Recording").GetAsInt() != 0;
  this->RecordAction->setChecked(records);
  if (this->Proxy && this->Awaited && !records)
  {
    this->Awaited = false;
    this->play();
  }
  else if (!this->Before.isEmpty() && vtkSMPropertyHelper(this->Proxy, "Touching").GetAsInt() == 0)
  {
    const QString before = std::exchange(this->Before, QString());
    const bool replays = std::strcmp(vtkSMPropertyHelper(this->Proxy, "DeviceName").GetAsString(), "replay") == 0;
    if (replays) // else another one was chosen meanwhile
    {
      pqHapticCommand(this->Proxy, "DeviceName", before);
    }
  }
}

void pqHapticRecordings::record(bool on)
{
  if (this->Proxy && on != (vtkSMPropertyHelper(this->Proxy, "Recording").GetAsInt() != 0))
  {
    vtkSMPropertyHelper(this->Proxy, "Recording").Set(on ? 1 : 0);
    this->Proxy->UpdateVTKObjects();
  }
}

void pqHapticRecordings::save()
{
  const QString file = AskForFile("hapticSaveRecording", tr("Save Recording"), pqFileDialog::AnyFile);
  if (this->Proxy && !file.isEmpty())
  {
    pqHapticCommand(this->Proxy, "SaveRecording", file);
  }
}

void pqHapticRecordings::open()
{
  const QString file = AskForFile("hapticOpenRecording", tr("Recording to Play"), pqFileDialog::ExistingFile);
  if (this->Proxy && !file.isEmpty())
  {
    pqHapticCommand(this->Proxy, "ReplayFile", file);
  }
}

void pqHapticRecordings::replay()
{
  if (!this->Proxy)
  {
    return;
  }
  this->Awaited = vtkSMPropertyHelper(this->Proxy, "Recording").GetAsInt() != 0;
  vtkSMPropertyHelper(this->Proxy, "Touching").Set(0); // ends a recording too, once its file is whole
  this->Proxy->UpdateVTKObjects();
  if (!this->Awaited)
  {
    this->play();
  }
}

void pqHapticRecordings::play()
{
  const QString device = vtkSMPropertyHelper(this->Proxy, "DeviceName").GetAsString();
  pqHapticCommand(this->Proxy, "DeviceName", "replay");
  vtkSMPropertyHelper(this->Proxy, "Touching").Set(1);
  this->Proxy->UpdateVTKObjects();
  this->Before = device != "replay" ? device : this->Before;
}

void pqHapticRecordings::showWay()
{
  const QString file = this->Proxy ? vtkSMPropertyHelper(this->Proxy, "ReplayFile").GetAsString() : "";
  if (!file.isEmpty())
  {
    pqLoadDataReaction::loadData(QStringList(file));
  }
}
