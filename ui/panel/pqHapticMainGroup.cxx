// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMainGroup.h"

#include "haptics/session/StateText.h"
#include "pqHapticButton.h"
#include "pqHapticController.h"
#include "pqHapticDeviceChoice.h"
#include "pqHapticFields.h"
#include "pqHapticLabel.h"
#include "pqHapticMouse.h"
#include "pqHapticProgress.h"
#include "pqHapticRecordingRows.h"
#include "pqHapticStrip.h"
#include "pqHapticTouchKinds.h"
#include "pqHapticViewFollower.h"
#include "pqPropertyLinks.h"
#include "vtkHapticSession.h"
#include "vtkSMProxy.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

pqHapticMainGroup::pqHapticMainGroup(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("mainGroup");
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  this->addDevice(form);
  this->addButtons(form);
  this->Rows.add(form, "main");
  this->Recording = new pqHapticRecordingRows(this);
  form->addRow(this->Recording);
  this->addStrips(form);
  auto* warning = pqHapticLabel(this, "notClinical", tr("No part of it has been validated for any medical purpose"));
  warning->setText(tr("Not for clinical use."));
  form->addRow(warning);
}

pqHapticMainGroup::~pqHapticMainGroup() = default;

void pqHapticMainGroup::addDevice(QFormLayout* form)
{
  this->Device = new pqHapticDeviceChoice(this);
  this->Device->setObjectName("device");
  form->addRow(pqHapticTitle("DeviceName"), this->Device);
}

void pqHapticMainGroup::addButtons(QFormLayout* form)
{
  this->Touch =
    pqHapticButton(this, "touch", pqHapticTitle("Touching"), tr("Touch every visible surface of the active view"));
  this->Touch->setCheckable(true);
  this->Release =
    pqHapticButton(this, "release", tr("Let &Go"), tr("Reduce the force to zero within 50 ms and stop touching"));
  this->Fit = pqHapticButton(
    this, "fit", tr("Fit"), tr("Set scale and offset so that the device's workspace contains all visible data"));
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : { this->Touch, this->Release, this->Fit })
  {
    buttons->addWidget(button, 1);
  }
  form->addRow(buttons);
  this->Status = pqHapticLabel(this, "status", tr("State of the touch, its reason, and the next step"));
  QFont bold = this->Status->font();
  bold.setBold(true);
  this->Status->setFont(bold);
  form->addRow(this->Status);
  this->Progress = new pqHapticProgress(this);
  form->addRow(this->Progress);
  this->Server = pqHapticLabel(this, "server", pqHapticReadoutTip("ServerText"));
  form->addRow(this->Server);
  this->MouseHelp =
    pqHapticLabel(this, "mouseHelp", tr("Functions of mouse and keyboard in the view while they move the hand"));
  form->addRow(this->MouseHelp);
  auto* controller = pqHapticController::instance();
  this->connect(
    this->Touch, &QPushButton::toggled, controller->kinds(), &pqHapticTouchKinds::prepare); // before the property
  this->connect(this->Release, &QPushButton::clicked, controller, &pqHapticController::release);
  this->connect(this->Fit, &QPushButton::clicked, controller, &pqHapticController::fitWorkspace);
}

void pqHapticMainGroup::addStrips(QFormLayout* form)
{
  this->Force = new pqHapticStrip(this, "forceStrip", tr("Force"), "N", 1.0);
  this->Depth = new pqHapticStrip(this, "depthStrip", tr("Depth"), "mm", 1.0);
  this->Lateness = new pqHapticStrip(this, "latenessStrip", tr("Lateness"), "ms", 1.0);
  this->Energy = new pqHapticStrip(this, "energyStrip", tr("Excess energy"), "mJ", 1.0);
  this->Force->setToolTip(pqHapticReadoutTip("ForceMagnitude"));
  this->Depth->setToolTip(tr("Distance from the hand to the proxy, as displacement of the device"));
  this->Lateness->setToolTip(pqHapticReadoutTip("LatenessP99"));
  this->Energy->setToolTip(pqHapticReadoutTip("ExcessEnergy"));
  for (pqHapticStrip* strip : { this->Force, this->Depth, this->Lateness, this->Energy })
  {
    form->addRow(strip);
  }
}

void pqHapticMainGroup::setProxy(vtkSMProxy* proxy, pqPropertyLinks& links)
{
  this->Device->setSession(proxy ? vtkHapticSession::SafeDownCast(proxy->GetClientSideObject()) : nullptr);
  for (QWidget* field : this->fields())
  {
    field->setEnabled(proxy != nullptr); // never the texts: they say why
  }
  if (!proxy)
  {
    return;
  }
  const auto link = [&](QObject* widget, const char* property, const char* signal, const char* name)
  { links.addTraceablePropertyLink(widget, property, signal, proxy, proxy->GetProperty(name)); };
  link(this->Device, "currentText", SIGNAL(currentTextChanged(const QString&)), "DeviceName");
  link(this->Touch, "checked", SIGNAL(toggled(bool)), "Touching");
  this->Recording->link(proxy, links);
  this->Rows.link(links, proxy);
}

QString pqHapticMainGroup::statusOf(vtkHapticSession* session) const
{
  const pqHapticController* controller = pqHapticController::instance();
  palpate::SessionGlance glance;
  glance.refusal = controller->refusal().toStdString();
  if (session)
  {
    glance.touching = session->GetTouching();
    glance.preparing = session->GetSceneProgress() < 1.0;
    glance.engage = static_cast<palpate::EngageState>(session->GetEngageState());
    glance.fault = session->GetFaultText();
    glance.warning = session->GetWarning();
    glance.problem = session->GetProblem();
    glance.limitedTo_N = session->GetForceLimited() ? session->GetForceMagnitude() : 0.0;
  }
  return QString::fromStdString(palpate::stateText(glance));
}

QString pqHapticMainGroup::serverOf(vtkHapticSession* session) const
{
  const QString sentence = session ? QString::fromStdString(session->GetServerText()) : QString();
  return sentence.isEmpty() ? sentence
                            : tr("Remote surfaces: %1; age %2 s, %3 ticks outside")
                                .arg(sentence)
                                .arg(session->GetServerAge(), 0, 'f', 1)
                                .arg(session->GetServerTicksBeyond());
}

void pqHapticMainGroup::followStrips(vtkHapticSession* session)
{
  if (!session || !session->GetTouching())
  {
    return; // what was measured last stays to be read
  }
  constexpr double milli = 1e3;
  this->Force->add(session->GetForceMagnitude());
  this->Depth->add(session->GetContacts() > 0 ? milli * session->GetDepth() / session->GetSetting("Scale") : 0.0);
  this->Lateness->add(session->GetLatenessP99() / milli);
  this->Energy->add(milli * session->GetExcessEnergy());
}

void pqHapticMainGroup::refresh(vtkHapticSession* session)
{
  auto* controller = pqHapticController::instance();
  this->Device->follow();
  pqHapticSay(this->Status, this->statusOf(session));
  this->Progress->refresh(session);
  pqHapticSay(this->Server, this->serverOf(session));
  this->Release->setEnabled(controller->touching());
  this->Recording->refresh(session);
  pqHapticSay(this->MouseHelp, controller->mouse()->help());
  this->followStrips(session);
}

QList<QWidget*> pqHapticMainGroup::fields() const
{
  return QList<QWidget*>{ this->Device, this->Touch, this->Release, this->Fit, this->Progress->field() } +
         this->Rows.fields("main") + this->Recording->fields();
}
