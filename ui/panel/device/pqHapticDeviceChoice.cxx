// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticDeviceChoice.h"

#include "devices/simulated/DeviceModels.h"
#include "vtkHapticKnownDevices.h"
#include "vtkHapticSession.h"

#include <QSignalBlocker>

namespace
{
/// Of a simulated hand that strokes by itself over the surface that is shown: on a model of a device that is sold and
/// moves in space. "" for all others, which only a program can lead.
QString SentenceOf(const QString& device)
{
  const palpate::DeviceModel* const model = palpate::deviceModel(device.toStdString());
  const bool leads = model && model->provenance == palpate::Provenance::Listed && !model->planar && !model->turns();
  return leads ? QObject::tr("Simulated hand on %1: strokes over the visible surface, with the forces of such a device")
                   .arg(QString::fromStdString(model->what))
               : QString();
}
} // namespace

pqHapticDeviceChoice::pqHapticDeviceChoice(QWidget* parent) : Superclass(parent)
{
  this->setToolTip(
    tr("Device that moves the hand: the mouse in the view, a simulated hand, a recording, or an attached device"));
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

/// No signal: the chosen device stays chosen, there or not.
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
    const QString simulated = SentenceOf(name);
    if (name == chosen || !simulated.isEmpty() || !this->Session->GetDevices()->GetForPrograms(i))
    {
      this->addItem(name);
      const QString problem = QString::fromUtf8(this->Session->GetDevices()->GetProblem(i));
      this->setItemData(this->count() - 1, problem.isEmpty() ? simulated : problem, Qt::ToolTipRole);
    }
  }
  if (this->findText(chosen) < 0)
  {
    this->addItem(chosen);
    this->setItemData(this->count() - 1, tr("the device is not attached"), Qt::ToolTipRole);
  }
  this->setCurrentText(chosen);
}
