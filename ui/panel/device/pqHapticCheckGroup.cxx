// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticCheckGroup.h"

#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "vtkHapticDeviceCheck.h"
#include "vtkHapticSession.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace
{
constexpr int wholeProgress = 100;
} // namespace

pqHapticCheckGroup::pqHapticCheckGroup(QWidget* parent)
  : Superclass(tr("Device check"), "check", parent), Verify(new QPushButton(this)), Adjust(new QPushButton(this)),
    Progress(new QProgressBar(this))
{
  this->Verify->setObjectName("verify");
  this->Verify->setToolTip(tr("Measure noise, range, response to gentle pushes and the device's own walls, with at "
                              "most 1/10 of its force. The panel gives the instructions"));
  this->Adjust->setObjectName("adjust");
  this->Adjust->setText(tr("Ad&just Device"));
  this->Adjust->setToolTip(
    tr("Save directions, range and the measured walls of the device, and apply them from the next touch"));
  this->Progress->setObjectName("progress");
  this->Progress->setRange(0, wholeProgress);
  this->Progress->setToolTip(tr("Progress of the check [%]"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(this->Verify);
  buttons->addWidget(this->Adjust);
  this->Form->addRow(buttons);
  this->Form->addRow(this->Progress);
  this->Ask = this->addText("ask", tr("Current instruction"));
  this->Result = this->addText("result", tr("Result of the check"));
  this->connect(this->Verify, &QPushButton::clicked, this, &pqHapticCheckGroup::startOrStop);
  this->connect(this->Adjust, &QPushButton::clicked, this, &pqHapticCheckGroup::keep);
  this->refresh(nullptr);
}

void pqHapticCheckGroup::refresh(vtkHapticSession* session)
{
  const int state = session ? session->GetDeviceCheck()->GetState() : vtkHapticDeviceCheck::CheckNone;
  const bool runs = state == vtkHapticDeviceCheck::CheckRuns;
  this->Verify->setEnabled(session && !session->GetTouching());
  this->Verify->setText(runs ? tr("Stop Chec&k") : tr("Verif&y Device"));
  this->Adjust->setEnabled(
    state == vtkHapticDeviceCheck::CheckPassed && *session->GetDeviceCheck()->GetCalibrationFolder() != '\0');
  this->Progress->setVisible(runs);
  this->Progress->setValue(session ? static_cast<int>(wholeProgress * session->GetDeviceCheck()->GetProgress()) : 0);
  pqHapticSay(this->Ask, session ? QString::fromUtf8(session->GetDeviceCheck()->GetAsk()) : QString());
  const QString result = session ? QString::fromUtf8(session->GetDeviceCheck()->GetResult()) : QString();
  pqHapticSay(this->Result, this->Note.isEmpty() ? result : this->Note);
}

QList<QWidget*> pqHapticCheckGroup::fields() const
{
  return { this->Verify, this->Adjust };
}

void pqHapticCheckGroup::startOrStop()
{
  vtkHapticSession* session = pqHapticController::instance()->session();
  if (!session)
  {
    return;
  }
  session->GetDeviceCheck()->GetState() == vtkHapticDeviceCheck::CheckRuns ? session->GetDeviceCheck()->Stop()
                                                                           : session->GetDeviceCheck()->Start();
  const bool refused = session->GetDeviceCheck()->GetState() == vtkHapticDeviceCheck::CheckNone;
  this->Note = refused ? QString::fromUtf8(session->GetProblem()) : QString();
  this->refresh(session);
}

void pqHapticCheckGroup::keep()
{
  vtkHapticSession* session = pqHapticController::instance()->session();
  if (session)
  {
    const bool kept = session->GetDeviceCheck()->KeepCalibration();
    this->Note = kept ? tr("Saved, and applied from the next touch on.") : QString::fromUtf8(session->GetProblem());
    this->refresh(session);
  }
}
