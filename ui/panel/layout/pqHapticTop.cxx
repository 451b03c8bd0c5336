// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticTop.h"

#include "haptics/session/StateText.h"
#include "pqHapticButton.h"
#include "pqHapticController.h"
#include "pqHapticDeviceChoice.h"
#include "pqHapticFields.h"
#include "pqHapticLines.h"
#include "pqHapticLink.h"
#include "pqHapticNumberText.h"
#include "pqHapticProgress.h"
#include "pqHapticTouchKinds.h"
#include "pqPropertyLinks.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkSMProxy.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
/// The longest sentence of a state, about 180 letters, in a dock of the width that ParaView gives it.
constexpr int statusLines = 4;
constexpr int betweenRows = 4; // [pixels]
/// Of forces [N] and depths [mm]: a hand feels no more.
constexpr int feltDecimals = 2;

/// Stiffness and *Mouse goes in by* may ask for more than the largest force.
double LimitedFrom_m(vtkHapticSession& session)
{
  const double largest_m = session.GetSight()->GetLargestDepth();
  return session.GetFollowsMouse() && session.GetSetting("PressDepth") > largest_m ? largest_m : 0.0;
}
} // namespace

pqHapticTop::pqHapticTop(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("top");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(betweenRows);
  this->addDevice(column);
  this->addButtons(column);
  this->Status =
    new pqHapticLines(this, "status", tr("State of the touch, its reason, and the next step"), statusLines);
  QFont bold = this->Status->font();
  bold.setBold(true);
  this->Status->setFont(bold);
  column->addWidget(this->Status);
  this->addHints(column);
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

pqHapticTop::~pqHapticTop() = default;

void pqHapticTop::addDevice(QVBoxLayout* column)
{
  this->Device = new pqHapticDeviceChoice(this);
  this->Device->setObjectName("device");
  auto* title = new QLabel(pqHapticTitle("DeviceName"), this);
  title->setBuddy(this->Device);
  auto* row = new QHBoxLayout;
  row->addWidget(title);
  row->addWidget(this->Device, 1);
  column->addLayout(row);
}

void pqHapticTop::addButtons(QVBoxLayout* column)
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
  column->addLayout(buttons);
  auto* controller = pqHapticController::instance();
  this->connect(
    this->Touch, &QPushButton::toggled, controller->kinds(), &pqHapticTouchKinds::prepare); // before the property
  this->connect(this->Release, &QPushButton::clicked, controller, &pqHapticController::release);
  this->connect(this->Fit, &QPushButton::clicked, controller, &pqHapticController::fitWorkspace);
}

void pqHapticTop::addHints(QVBoxLayout* column)
{
  this->Hints = new QStackedWidget(this);
  this->Hints->setObjectName("hints");
  this->Hints->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  this->Notes = new QWidget(this->Hints);
  this->Notes->setObjectName("notes");
  auto* notes = new QVBoxLayout(this->Notes);
  notes->setContentsMargins(0, 0, 0, 0);
  notes->setSpacing(0);
  this->ContactLine = new pqHapticLines(this->Notes, "contactLine",
    tr("Force on the hand and its depth behind the surface, now, or at most during the last contact"), 1);
  this->Server = new pqHapticLines(this->Notes, "server", pqHapticReadoutTip("ServerText"), 1);
  notes->addWidget(this->ContactLine);
  notes->addWidget(this->Server);
  this->Progress = new pqHapticProgress(this->Hints);
  this->Hints->addWidget(this->Notes);
  this->Hints->addWidget(this->Progress);
  column->addWidget(this->Hints);
}

void pqHapticTop::setProxy(vtkSMProxy* proxy, pqPropertyLinks& links)
{
  this->Last = {};
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
  { pqHapticLink::add(links, widget, property, signal, proxy, name); };
  link(this->Device, "currentText", SIGNAL(currentTextChanged(const QString&)), "DeviceName");
  link(this->Touch, "checked", SIGNAL(toggled(bool)), "Touching");
}

QString pqHapticTop::statusOf(vtkHapticSession* session) const
{
  const pqHapticController* controller = pqHapticController::instance();
  palpate::SessionGlance glance;
  glance.refusal = controller->refusal().toStdString();
  if (session)
  {
    glance.touching = session->GetTouching();
    glance.preparing = session->GetSceneProgress() < 1.0;
    glance.engage = static_cast<palpate::EngageState>(session->GetEngageState());
    glance.refused = session->GetSceneRefusal();
    glance.damaged = session->GetSceneDamage();
    glance.fault = session->GetFaultText();
    glance.warning = session->GetWarning();
    glance.problem = session->GetProblem();
    glance.limitedFrom_m = LimitedFrom_m(*session);
    glance.limitedTo_N = session->GetForceLimited() ? session->GetForceMagnitude() : 0.0;
  }
  return QString::fromStdString(palpate::stateText(glance));
}

QString pqHapticTop::serverOf(vtkHapticSession* session) const
{
  const QString sentence = session ? QString::fromStdString(session->GetServerText()) : QString();
  return sentence.isEmpty() ? sentence
                            : tr("Remote surfaces: %1; age %2 s, %3 ticks outside")
                                .arg(sentence)
                                .arg(session->GetServerAge(), 0, 'f', 1)
                                .arg(session->GetServerTicksBeyond());
}

QString pqHapticTop::contactOf(vtkHapticSession* session)
{
  const bool now = session && session->GetTouching() && session->GetContacts() > 0;
  if (now)
  {
    const double force_N = session->GetForceMagnitude();
    const double depth_mm = 1e3 * session->GetDepth() / session->GetSetting("Scale");
    const Contact before = this->Last.Now ? this->Last : Contact();
    const QString source = QString::fromUtf8(session->GetContactSource()); // known while somebody looks it up
    this->Last = { source.isEmpty() ? before.Source : source, std::max(before.Force_N, force_N),
      std::max(before.Depth_mm, depth_mm), true, true };
    return tr("Contact: %1 N, %2 mm deep%3")
      .arg(pqHapticNumberText(force_N, feltDecimals), pqHapticNumberText(depth_mm, feltDecimals),
        this->Last.Source.isEmpty() ? QString() : ", " + this->Last.Source);
  }
  this->Last.Now = false;
  return !this->Last.Ever ? tr("No contact yet.")
                          : tr("Last contact: at most %1 N, %2 mm deep%3")
                              .arg(pqHapticNumberText(this->Last.Force_N, feltDecimals),
                                pqHapticNumberText(this->Last.Depth_mm, feltDecimals),
                                this->Last.Source.isEmpty() ? QString() : ", " + this->Last.Source);
}

void pqHapticTop::refresh(vtkHapticSession* session)
{
  this->Device->follow();
  this->Status->say(this->statusOf(session));
  this->Progress->refresh(session);
  this->Hints->setCurrentWidget(this->Progress->waits() ? static_cast<QWidget*>(this->Progress) : this->Notes);
  this->ContactLine->say(this->contactOf(session));
  this->Server->say(this->serverOf(session));
  this->Release->setEnabled(pqHapticController::instance()->touching());
}

QList<QWidget*> pqHapticTop::fields() const
{
  return { this->Device, this->Touch, this->Release, this->Fit, this->Progress->field() };
}
