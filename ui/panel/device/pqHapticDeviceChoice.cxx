// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticDeviceChoice.h"

#include "vtkHapticSession.h"

#include <QSignalBlocker>

pqHapticDeviceChoice::pqHapticDeviceChoice(QWidget* parent) : Superclass(parent)
{
  this->setToolTip(tr("Who moves the hand: the mouse in the view, a recording, or a device that is plugged in"));
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
    this->Session->LookForDevices();
    this->list();
  }
  this->Superclass::showPopup();
}

void pqHapticDeviceChoice::follow()
{
  if (this->Session && this->currentText() != QString::fromUtf8(this->Session->GetDeviceName()))
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
  const QString chosen = QString::fromUtf8(this->Session->GetDeviceName());
  for (int i = 0; i < this->Session->GetNumberOfKnownDevices(); ++i)
  {
    const QString name = QString::fromUtf8(this->Session->GetKnownDeviceName(i));
    if (name == chosen || !this->Session->GetKnownDeviceForPrograms(i))
    {
      this->addItem(name);
      this->setItemData(this->count() - 1, QString::fromUtf8(this->Session->GetKnownDeviceProblem(i)), Qt::ToolTipRole);
    }
  }
  if (this->findText(chosen) < 0)
  {
    this->addItem(chosen);
    this->setItemData(this->count() - 1, tr("it is not plugged in"), Qt::ToolTipRole);
  }
  this->setCurrentText(chosen);
}
