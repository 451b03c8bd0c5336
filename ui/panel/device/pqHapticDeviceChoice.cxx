// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticDeviceChoice.h"

#include "vtkHapticKnownDevices.h"
#include "vtkHapticSession.h"

#include <QSignalBlocker>

pqHapticDeviceChoice::pqHapticDeviceChoice(QWidget* parent) : Superclass(parent)
{
  this->setToolTip(tr("Device that moves the hand: the mouse in the view, a recording, or an attached device"));
}

pqHapticDeviceChoice::~pqHapticDeviceChoice() = default;

void pqHapticDeviceChoice::setSession(vtkHapticSession* session)
{
  this->Session = session;
  this->list();
}

void pqHapticDeviceChoice::showPopup()
{
  if (this->Session)
  {
    this->Session->GetDevices()->Look();
    this->list();
  }
  this->Superclass::showPopup();
}

void pqHapticDeviceChoice::follow()
{
  if (this->Session && this->currentText() != QString::fromUtf8(this->Session->GetSettingText("DeviceName")))
  {
    this->list();
  }
}

/// Nobody hears of it: what is chosen stays chosen, there or not.
void pqHapticDeviceChoice::list()
{
  const QSignalBlocker blocker(this);
  this->clear();
  if (!this->Session)
  {
    return;
  }
  const QString chosen = QString::fromUtf8(this->Session->GetSettingText("DeviceName"));
  for (int i = 0; i < this->Session->GetDevices()->GetNumberOfDevices(); ++i)
  {
    const QString name = QString::fromUtf8(this->Session->GetDevices()->GetName(i));
    if (name == chosen || !this->Session->GetDevices()->GetForPrograms(i))
    {
      this->addItem(name);
      this->setItemData(
        this->count() - 1, QString::fromUtf8(this->Session->GetDevices()->GetProblem(i)), Qt::ToolTipRole);
    }
  }
  if (this->findText(chosen) < 0)
  {
    this->addItem(chosen);
    this->setItemData(this->count() - 1, tr("the device is not attached"), Qt::ToolTipRole);
  }
  this->setCurrentText(chosen);
}
