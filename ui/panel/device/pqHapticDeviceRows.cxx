// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticDeviceRows.h"

#include "pqCoreUtilities.h"
#include "pqFileDialog.h"
#include "pqHapticButton.h"
#include "pqHapticFields.h"
#include "pqHapticLabel.h"
#include "pqHapticLink.h"
#include "pqUndoStack.h"
#include "vtkHapticSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace
{
constexpr int Buttons = 8;
/// Row 0 is nothing, then the buttons, any of them, the grip, and last choices that only a script can make.
constexpr int AnyButton = Buttons + 1, Grip = Buttons + 2, Other = Buttons + 3;
constexpr int AllMask = (1 << Buttons) - 1;

int MaskOf(int row)
{
  return row >= 1 && row <= Buttons ? 1 << (row - 1) : row == AnyButton ? AllMask : 0;
}

int RowOf(int mask, bool grip)
{
  for (int row = 0; row < Other; ++row)
  {
    if (MaskOf(row) == mask && (row == Grip) == grip)
    {
      return row;
    }
  }
  return Other;
}
} // namespace

pqHapticDeviceRows::pqHapticDeviceRows(QFormLayout* form) : Superclass(form->parentWidget())
{
  QWidget* parent = form->parentWidget();
  this->Notes = pqHapticLabel(parent, "deviceNotes", tr("Kind of the device, and functions it lacks"));
  form->addRow(this->Notes);
  this->Wheel = pqHapticSwitchRow(form, "wheel", "Wheel");
  this->DeadMan = new QComboBox(parent);
  this->DeadMan->setObjectName("deadMan");
  pqHapticSetProperty(this->DeadMan, "DeadManButtons, DeadManGrip");
  this->DeadMan->setToolTip(tr("Dead-man switch: force flows only while it is pressed. After release the force is zero "
                               "within 50 ms, and restarts through its ramp"));
  this->DeadMan->addItem(tr("nothing"));
  for (int button = 1; button <= Buttons; ++button)
  {
    this->DeadMan->addItem(tr("button %1").arg(button));
  }
  this->DeadMan->addItems({ tr("any button"), tr("the grip"), tr("as set by a script") });
  form->addRow(pqHapticTitle("DeadManButtons"), this->DeadMan);
  this->Link = pqHapticLabel(parent, "link",
    tr("USB link: reports per second, effects re-armed before expiry, stalled writes, disconnects, malformed reports"));
  form->addRow(this->Link);
  this->Step = pqHapticButton(parent, "deviceStep", QString(), tr("The step that the device waits for is done"));
  this->Step->hide();
  form->addRow(this->Step);
  QObject::connect(this->Step, &QPushButton::clicked, this, &pqHapticDeviceRows::prepare);
  QObject::connect(this->Wheel, &QCheckBox::toggled, this, &pqHapticDeviceRows::sayWheel);
  QObject::connect(
    this->DeadMan, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &pqHapticDeviceRows::choose);
}

void pqHapticDeviceRows::choose(int row)
{
  if (this->Proxy && row != Other)
  {
    SCOPED_UNDO_SET(pqHapticStepName(*this->Proxy, "DeadManButtons"));
    vtkSMPropertyHelper(this->Proxy, "DeadManButtons").Set(MaskOf(row));
    vtkSMPropertyHelper(this->Proxy, "DeadManGrip").Set(row == Grip ? 1 : 0);
    this->Proxy->UpdateVTKObjects();
  }
}

void pqHapticDeviceRows::sayWheel(bool on)
{
  if (this->Proxy)
  {
    SCOPED_UNDO_SET(pqHapticStepName(*this->Proxy, "Wheel"));
    vtkSMPropertyHelper(this->Proxy, "Wheel").Set(on ? 1 : 0);
    this->Proxy->UpdateVTKObjects();
  }
}

/// On this computer, where the device is. Empty: the person has chosen none.
QString pqHapticDeviceRows::askForFile() const
{
  pqFileDialog dialog(nullptr, pqCoreUtilities::mainWidget(), this->Step->text(), QString(), QString(), false);
  dialog.setObjectName("hapticDeviceFile");
  dialog.setFileMode(pqFileDialog::ExistingFile);
  return dialog.exec() == QDialog::Accepted ? dialog.getSelectedFiles().value(0) : QString();
}

/// A button whose text ends with dots asks for a file first.
void pqHapticDeviceRows::prepare()
{
  const bool wantsFile = this->Step->text().endsWith("...");
  const QString file = wantsFile ? this->askForFile() : QString();
  if (!this->Proxy || (wantsFile && file.isEmpty()))
  {
    return;
  }
  vtkSMPropertyHelper(this->Proxy, "DeviceFile").Set(file.toUtf8().constData());
  this->Proxy->UpdateVTKObjects();
  this->Proxy->InvokeCommand("PrepareDevice");
}

void pqHapticDeviceRows::refresh(vtkHapticSession* session)
{
  const auto text = [](const char* utf8) { return QString::fromUtf8(utf8); };
  QString notes;
  if (session)
  {
    notes = QString("%1. %2").arg(text(session->GetDeviceKind()), text(session->GetDeviceNotes())).trimmed();
    notes[0] = notes[0].toUpper();
  }
  pqHapticSay(this->Notes, notes);
  pqHapticSay(this->Link, session ? text(session->GetLinkText()) : QString());
  const QString step = session ? text(session->GetDeviceButton()) : QString();
  this->Step->setText(step);
  this->Step->setVisible(!step.isEmpty());
  const QSignalBlocker blocker(this->DeadMan), wheelBlocker(this->Wheel);
  this->Wheel->setChecked(session && session->IsOn("Wheel"));
  this->DeadMan->setCurrentIndex(
    session ? RowOf(static_cast<int>(session->GetSetting("DeadManButtons")), session->IsOn("DeadManGrip")) : 0);
}

QList<QWidget*> pqHapticDeviceRows::fields() const
{
  return { this->Wheel, this->DeadMan, this->Step };
}
