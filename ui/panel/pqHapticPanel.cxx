// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticPanel.h"

#include "pqHapticCheckGroup.h"
#include "pqHapticContactGroup.h"
#include "pqHapticController.h"
#include "pqHapticDeviceRows.h"
#include "pqHapticFieldGroup.h"
#include "pqHapticFields.h"
#include "pqHapticFold.h"
#include "pqHapticLabel.h"
#include "pqHapticMainGroup.h"
#include "pqHapticMarksGroup.h"
#include "pqHapticMaterialGroup.h"
#include "pqHapticMechanismGroup.h"
#include "pqHapticReadout.h"
#include "pqHapticSettingRows.h"
#include "pqHapticSoftGroup.h"
#include "pqHapticSourceGroup.h"
#include "pqHapticToolGroup.h"
#include "pqHapticViewFollower.h"
#include "pqHapticViewGroup.h"
#include "pqPropertyLinks.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkSMProxy.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <vector>

namespace
{
/// Read-outs change ten times a second: faster cannot be read.
constexpr int refreshPeriod_ms = 100;

QFormLayout* Group(QVBoxLayout* column, const char* name, const QString& title)
{
  auto* group = new QGroupBox(title);
  group->setObjectName(name);
  column->addWidget(group);
  auto* form = new QFormLayout(group);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  return form;
}
} // namespace

class pqHapticPanel::Internals
{
public:
  QScrollArea* Scroll;
  pqHapticMainGroup* Main;
  pqHapticFold* AtContact;
  pqHapticContactGroup* Place;
  pqHapticMarksGroup* Marks;
  pqHapticFold* Advanced;
  pqHapticDeviceRows* DeviceRows;
  QComboBox* Hand;
  QDoubleSpinBox* PressDepth;
  pqHapticSettingRows Rows;
  pqHapticMaterialGroup* Material;
  std::vector<pqHapticGroup*> Groups; ///< those with a class of their own, from top to bottom
  QList<QWidget*> Fields;             ///< of the rest, in the order of the Tab key
  QLabel* Reason;
  struct Readout
  {
    QLabel* Label;
    QString pqHapticReadout::*Text;
  };
  std::vector<Readout> Readouts;
  QPlainTextEdit* Scene;
  QTimer Refresh;
  pqPropertyLinks Links;

  void addContact(QVBoxLayout* column);
  /// A group with a class of its own, its fields next for the Tab key.
  void addGroup(QVBoxLayout* column, pqHapticGroup* group);
  void addSettings(QFormLayout* form, const char* group);
  void addReadout(
    QFormLayout* form, const char* name, const QString& title, QString pqHapticReadout::*text, const QString& tip);
  void fillRest(QVBoxLayout* rest);
  void addHand(QVBoxLayout* column);
  void addStability(QVBoxLayout* column);
  void addState(QVBoxLayout* column);
  void addServo(QVBoxLayout* column);
  void addScene(QVBoxLayout* column);
  void setTabOrder();
  void fitWidth();
  /// What stands in the rows that are folded at first.
  void showMeasured(vtkHapticSession* session, const pqHapticViewFollower& follower);
  void followMaterials(vtkHapticSession& session, pqHapticViewFollower& follower);

  vtkMTimeType MaterialTime = 0; ///< of the settings the view's scene was made with
};

void pqHapticPanel::Internals::addHand(QVBoxLayout* column)
{
  QFormLayout* form = Group(column, "handGroup", tr("Hand"));
  this->DeviceRows = new pqHapticDeviceRows(form);
  this->Hand = pqHapticChoiceRow(form, "hand", "Hand");
  this->PressDepth = pqHapticNumberRow(form, "pressDepth", "PressDepth", 5);
  this->Fields += this->DeviceRows->fields() + QList<QWidget*>{ this->Hand, this->PressDepth };
}

void pqHapticPanel::Internals::addGroup(QVBoxLayout* column, pqHapticGroup* group)
{
  column->addWidget(group);
  this->Groups.push_back(group);
  this->Fields += group->fields();
}

void pqHapticPanel::Internals::addSettings(QFormLayout* form, const char* group)
{
  this->Rows.add(form, group);
  this->Fields += this->Rows.fields(group);
}

/// Without a title it is as wide as the form.
void pqHapticPanel::Internals::addReadout(
  QFormLayout* form, const char* name, const QString& title, QString pqHapticReadout::*text, const QString& tip)
{
  QLabel* const label = pqHapticLabel(form->parentWidget(), name, tip);
  title.isEmpty() ? form->addRow(label) : form->addRow(title, label);
  this->Readouts.push_back({ label, text });
}

void pqHapticPanel::Internals::addStability(QVBoxLayout* column)
{
  QFormLayout* form = Group(column, "stabilityGroup", tr("Stability"));
  this->addSettings(form, "stability");
  this->addReadout(
    form, "stability", {}, &pqHapticReadout::Stability, tr("Largest stable stiffness of this device, and the reason"));
}

void pqHapticPanel::Internals::addState(QVBoxLayout* column)
{
  using Now = pqHapticReadout;
  QFormLayout* form = Group(column, "stateGroup", tr("State"));
  this->addReadout(form, "state", tr("State"), &Now::State,
    tr("safe: no force. armed: waits until the hand is free of contact. engaged: force flows. fault: no force"));
  this->Reason = pqHapticLabel(form->parentWidget(), "reason", tr("Reason why there is no force, and the remedy"));
  form->addRow(this->Reason);
  this->addReadout(
    form, "force", tr("Force"), &Now::Force, tr("Current force on the hand, and the largest so far [N]"));
  this->addReadout(
    form, "used", tr("Stiffness"), &Now::Stiffness, tr("Current stiffness of the spring, after all limits [N/m]"));
  this->addReadout(form, "energy", tr("Energy"), &Now::Energy,
    tr("Work done on the hand [mJ], negative if the hand did work; excess of the returned energy over the energy "
       "stored in "
       "the spring, now and at most [mJ]"));
  this->addReadout(form, "stabiliser", tr("Stabiliser"), &Now::Stabiliser,
    tr("Part of the force that the passivity controller adds [N]"));
  this->addReadout(form, "friction", tr("Friction"), &Now::Friction,
    tr("State of friction: sticks or slips; none without contact or friction"));
  this->addReadout(
    form, "contact", tr("Contact"), &Now::Contact, tr("Time in contact [s], and number of contact planes"));
  this->addReadout(form, "motionLag", tr("Motion lag"), &Now::MotionLag,
    tr("Delay of moving surfaces [ms]; 0 when all surfaces are at rest"));
}

void pqHapticPanel::Internals::addServo(QVBoxLayout* column)
{
  using Now = pqHapticReadout;
  QFormLayout* form = Group(column, "servoGroup", tr("Servo"));
  this->addReadout(form, "rate", tr("Rate"), &Now::Rate, tr("Ticks per second [Hz]"));
  this->addReadout(
    form, "lateness", tr("Late p50/p99"), &Now::Lateness, tr("Lateness of ticks: median and 99th percentile [us]"));
  this->addReadout(form, "cost", tr("Cost p50/p99/p99.9"), &Now::Cost,
    tr("Duration of a tick: median, 99th and 99.9th percentile [us]"));
  this->addReadout(form, "ticks", tr("Ticks"), &Now::Ticks,
    tr("Computed ticks and missed periods; missed periods are never caught up"));
  this->addReadout(
    form, "scheduling", {}, &Now::Scheduling, tr("Scheduling granted to the servo thread by the operating system"));
}

void pqHapticPanel::Internals::addScene(QVBoxLayout* column)
{
  QFormLayout* form = Group(column, "sceneGroup", tr("Scene"));
  this->addSettings(form, "scene");
  this->addReadout(form, "plan", {}, &pqHapticReadout::Plan, tr("Rendering plan of the scene, and its reasons"));
  this->Scene = new QPlainTextEdit(form->parentWidget());
  this->Scene->setObjectName("scene");
  this->Scene->setReadOnly(true);
  this->Scene->setTabChangesFocus(true);
  this->Scene->setMinimumHeight(110);
  this->Scene->setToolTip(tr("Touchable surfaces, repairs, refusals with their reasons, and the plan"));
  form->addRow(this->Scene);
  this->Fields.push_back(this->Scene);
}

void pqHapticPanel::Internals::setTabOrder()
{
  const QList<QWidget*> order = this->Main->fields() + QList<QWidget*>{ this->AtContact } + this->Marks->fields() +
                                QList<QWidget*>{ this->Advanced } + this->Fields;
  for (int i = 1; i < order.size(); ++i)
  {
    QWidget::setTabOrder(order[i - 1], order[i]);
  }
}

/// Folded at first, and not looked up until it is seen.
void pqHapticPanel::Internals::addContact(QVBoxLayout* column)
{
  this->AtContact = new pqHapticFold(column, "inspection", tr("Contact"), tr("Data at the contact, and marks"));
  this->Place = new pqHapticContactGroup;
  this->Marks = new pqHapticMarksGroup;
  this->AtContact->rows()->addWidget(this->Place);
  this->AtContact->rows()->addWidget(this->Marks);
  const auto show = [this] { this->Scroll->ensureWidgetVisible(this->Marks); };
  QObject::connect(this->AtContact, &QToolButton::toggled, this->Marks, [show] { QTimer::singleShot(0, show); });
}

void pqHapticPanel::Internals::fillRest(QVBoxLayout* rest)
{
  this->addHand(rest);
  this->addGroup(rest, new pqHapticViewGroup);
  this->addGroup(rest, new pqHapticToolGroup);
  this->addGroup(rest, new pqHapticSoftGroup);
  this->addGroup(rest, new pqHapticMechanismGroup);
  this->addSettings(Group(rest, "contactGroup", tr("Contact model")), "contact");
  this->addSettings(Group(rest, "frictionGroup", tr("Friction")), "friction");
  this->addGroup(rest, new pqHapticSourceGroup);
  this->Material = new pqHapticMaterialGroup;
  this->addGroup(rest, this->Material);
  this->addGroup(rest, new pqHapticFieldGroup);
  this->addStability(rest);
  this->addGroup(rest, new pqHapticCheckGroup);
  this->addState(rest);
  this->addServo(rest);
  this->addScene(rest);
}

/// What is unfolded may be wider, and a scroll bar takes from it: nothing is cut off at the side.
void pqHapticPanel::Internals::fitWidth()
{
  const int bar = this->Scroll->verticalScrollBar()->sizeHint().width();
  const int width = this->Scroll->widget()->minimumSizeHint().width() + bar + 2 * this->Scroll->frameWidth();
  if (width != this->Scroll->minimumWidth())
  {
    this->Scroll->setMinimumWidth(width);
  }
}

/// Settings can change without a frame being drawn, from a script for one.
void pqHapticPanel::Internals::followMaterials(vtkHapticSession& session, pqHapticViewFollower& follower)
{
  if (this->Material->isVisible()) // looking at all sources costs too much for what nobody sees
  {
    this->Material->setArrayNames(follower.arrayNames());
  }
  const bool read = session.GetSceneProgress() < 1.0; // in the background: a hidden view asks for no frame
  if (session.GetSight()->GetMaterialTime() != this->MaterialTime || read)
  {
    this->MaterialTime = session.GetSight()->GetMaterialTime();
    follower.refresh();
  }
}

pqHapticPanel::pqHapticPanel(const QString& title, QWidget* parent, Qt::WindowFlags flags)
  : Superclass(title, parent, flags)
{
  this->build();
}

pqHapticPanel::pqHapticPanel(QWidget* parent, Qt::WindowFlags flags) : Superclass(parent, flags)
{
  this->build();
}

pqHapticPanel::~pqHapticPanel() = default;

void pqHapticPanel::build()
{
  this->Widgets = std::make_unique<Internals>();
  this->setObjectName("pqHapticPanel");
  this->setWindowTitle(tr("Haptics"));
  auto* scroll = this->Widgets->Scroll = new QScrollArea(this);
  scroll->setObjectName("scroll");
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* body = new QWidget(scroll);
  body->setObjectName("body");
  auto* column = new QVBoxLayout(body);
  this->Widgets->Main = new pqHapticMainGroup(body);
  column->addWidget(this->Widgets->Main);
  this->Widgets->addContact(column);
  // What is set once, or never.
  this->Widgets->Advanced =
    new pqHapticFold(column, "advanced", tr("Adva&nced"), tr("All other settings and measurements"));
  this->Widgets->fillRest(this->Widgets->Advanced->rows());
  this->connect(this->Widgets->Advanced, &QToolButton::toggled, this, &pqHapticPanel::refresh);
  column->addStretch(1);
  this->Widgets->setTabOrder();
  scroll->setWidget(body);
  this->setWidget(scroll);

  auto* controller = pqHapticController::instance();
  this->connect(controller, &pqHapticController::sessionChanged, this, &pqHapticPanel::setProxy);
  this->connect(&this->Widgets->Refresh, &QTimer::timeout, this, &pqHapticPanel::refresh);
  this->setProxy(controller->sessionProxy());
  this->Widgets->Refresh.start(refreshPeriod_ms);
}

void pqHapticPanel::setProxy(vtkSMProxy* proxy)
{
  Internals& w = *this->Widgets;
  w.Links.clear();
  w.DeviceRows->setProxy(proxy);
  w.Main->setProxy(proxy, w.Links);
  w.Advanced->body()->setEnabled(proxy != nullptr);
  if (!proxy)
  {
    this->refresh();
    return;
  }
  pqHapticFill(w.Hand, proxy->GetProperty("Hand"));
  const auto link = [&](QObject* widget, const char* property, const char* signal, const char* name)
  { w.Links.addTraceablePropertyLink(widget, property, signal, proxy, proxy->GetProperty(name)); };
  link(w.Hand, "currentText", SIGNAL(currentTextChanged(const QString&)), "Hand");
  link(w.PressDepth, "value", SIGNAL(valueChanged(double)), "PressDepth");
  for (pqHapticGroup* const group : w.Groups)
  {
    group->link(w.Links, proxy);
  }
  w.Rows.link(w.Links, proxy);
  this->refresh();
}

void pqHapticPanel::refresh()
{
  auto* controller = pqHapticController::instance();
  vtkHapticSession* session = controller->session();
  if (session)
  {
    session->Update();
    this->Widgets->followMaterials(*session, *controller->follower());
  }
  Internals& w = *this->Widgets;
  w.fitWidth();
  w.Main->refresh(session);
  w.Place->refresh(session);
  w.Marks->refresh(session);
  if (w.Advanced->isChecked()) // a text that changes has the whole panel laid out again, seen or not
  {
    w.showMeasured(session, *controller->follower());
  }
}

void pqHapticPanel::Internals::showMeasured(vtkHapticSession* session, const pqHapticViewFollower& follower)
{
  const pqHapticReadout now = session ? pqHapticReadout::of(*session) : pqHapticReadout();
  for (pqHapticGroup* const group : this->Groups)
  {
    group->refresh(session);
  }
  this->DeviceRows->refresh(session);
  this->Hand->setEnabled(session && session->GetDeviceTakesHand());
  this->PressDepth->setEnabled(session && session->GetFollowsMouse());
  for (const Readout& readout : this->Readouts)
  {
    readout.Label->setText(now.*readout.Text);
  }
  pqHapticSay(this->Reason, now.Reason);
  const QString scene = follower.report() + now.Scene;
  if (scene != this->Scene->toPlainText())
  {
    this->Scene->setPlainText(scene);
  }
}
