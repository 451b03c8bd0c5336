// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticPanel.h"

#include "pqHapticCharts.h"
#include "pqHapticCheckGroup.h"
#include "pqHapticContactGroup.h"
#include "pqHapticController.h"
#include "pqHapticDeviceRows.h"
#include "pqHapticFieldGroup.h"
#include "pqHapticFields.h"
#include "pqHapticFold.h"
#include "pqHapticGlossary.h"
#include "pqHapticLabel.h"
#include "pqHapticLink.h"
#include "pqHapticMainGroup.h"
#include "pqHapticMarksGroup.h"
#include "pqHapticMaterialGroup.h"
#include "pqHapticMechanismGroup.h"
#include "pqHapticMouseHelp.h"
#include "pqHapticPageUse.h"
#include "pqHapticPages.h"
#include "pqHapticReadout.h"
#include "pqHapticSceneUnit.h"
#include "pqHapticSearch.h"
#include "pqHapticSettingRows.h"
#include "pqHapticSoftGroup.h"
#include "pqHapticSourceGroup.h"
#include "pqHapticToolGroup.h"
#include "pqHapticTop.h"
#include "pqHapticViewFollower.h"
#include "pqHapticViewGroup.h"
#include "pqPropertyLinks.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkSMProxy.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QTimer>
#include <QVBoxLayout>

#include <vector>

namespace
{
/// Read-outs change ten times a second: faster cannot be read.
constexpr int refreshPeriod_ms = 100, refreshesInSecond = 10;

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
  pqHapticTop* Top;
  pqHapticSearch* Search;
  pqHapticPages* Pages;
  pqHapticMouseHelp* Help;
  pqHapticCharts* Charts;
  pqHapticFold* ChartsFold;
  pqHapticMainGroup* Main;
  pqHapticContactGroup* Place;
  pqHapticMarksGroup* Marks;
  pqHapticDeviceRows* DeviceRows;
  QComboBox* Hand;
  pqHapticSettingRows Rows;
  pqHapticMaterialGroup* Material;
  std::vector<pqHapticGroup*> Groups; ///< those with a class of their own, from top to bottom
  QList<QWidget*> Fields;             ///< of the pages, in the order of the Tab key
  QLabel* Reason;
  struct Readout
  {
    QLabel* Label;
    QString pqHapticReadout::*Text;
  };
  std::vector<Readout> Readouts;
  pqHapticSceneUnit Unit;
  QPlainTextEdit* Scene;
  QTimer Refresh;
  pqPropertyLinks Links;

  /// A group with a class of its own, its fields next for the Tab key.
  void addGroup(QVBoxLayout* column, pqHapticGroup* group);
  void addSettings(QFormLayout* form, const char* group);
  void addReadout(
    QFormLayout* form, const char* name, const QString& title, QString pqHapticReadout::*text, const QString& tip);
  QLayout* searchRow(QWidget* panel);
  void fillPages();
  void addMain(QVBoxLayout* column);
  void addContact(QVBoxLayout* column);
  void addHand(QVBoxLayout* column);
  void addStability(QVBoxLayout* column);
  void addState(QVBoxLayout* column);
  void addServo(QVBoxLayout* column);
  void addScene(QVBoxLayout* column);
  void setTabOrder();
  /// The rows that a search finds, which a read-out may have shown or hidden since.
  void showFound();
  void searched();
  /// The state of the session in the rows that are visible: a text that changes has its page laid out again.
  void showMeasured(vtkHapticSession* session, const pqHapticViewFollower& follower);
  void followMaterials(vtkHapticSession& session, pqHapticViewFollower& follower);
  int Refreshes = 0;             ///< of the main page: looking at all sources costs much
  vtkMTimeType MaterialTime = 0; ///< of the settings the view's scene was made with
};

void pqHapticPanel::Internals::addMain(QVBoxLayout* column)
{
  this->Main = new pqHapticMainGroup;
  column->addWidget(this->Main);
  this->Fields += this->Main->fields();
}

void pqHapticPanel::Internals::addHand(QVBoxLayout* column)
{
  QFormLayout* form = Group(column, "handGroup", tr("Hand"));
  this->DeviceRows = new pqHapticDeviceRows(form);
  this->Hand = pqHapticChoiceRow(form, "hand", "Hand");
  this->Fields += this->DeviceRows->fields() + QList<QWidget*>{ this->Hand };
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
  const QList<QWidget*> order = this->Top->fields() +
                                QList<QWidget*>{ this->Search, this->ChartsFold, this->Help->fold() } +
                                this->Pages->fields() + this->Fields;
  for (int i = 1; i < order.size(); ++i)
  {
    QWidget::setTabOrder(order[i - 1], order[i]);
  }
}

/// The data at the contact are not looked up until they are seen.
void pqHapticPanel::Internals::addContact(QVBoxLayout* column)
{
  this->Place = new pqHapticContactGroup;
  this->Marks = new pqHapticMarksGroup;
  column->addWidget(this->Place);
  column->addWidget(this->Marks);
  this->Fields += this->Marks->fields();
  this->addSettings(Group(column, "contactGroup", tr("Contact model")), "contact");
}

void pqHapticPanel::Internals::fillPages()
{
  const auto page = [this](const char* name, const QString& title, const QString& tip)
  { return this->Pages->add(name, title, tip); };
  this->addMain(page("main", tr("Main"), tr("The settings that are needed first, and recordings")));
  this->addContact(page("contact", tr("Contact"), tr("Data at the contact, and marks")));
  QVBoxLayout* const material = page("material", tr("Material"), tr("Material of one source, or from its data"));
  this->addGroup(material, new pqHapticSourceGroup);
  this->Material = new pqHapticMaterialGroup;
  this->addGroup(material, this->Material);
  this->addGroup(page("field", tr("Field"), tr("Values of a volume that are felt")), new pqHapticFieldGroup);
  QVBoxLayout* const lines = page("lines", tr("Lines"), tr("Lines as walls, and points"));
  this->addSettings(Group(lines, "linesGroup", tr("Lines")), "lines");
  this->addGroup(page("tool", tr("Tool"), tr("A rigid body in the hand")), new pqHapticToolGroup);
  this->addGroup(page("tissue", tr("Tissue"), tr("A soft body under the hand")), new pqHapticSoftGroup);
  this->addGroup(
    page("mechanism", tr("Mechanism"), tr("Bodies with constraints between them")), new pqHapticMechanismGroup);
  QVBoxLayout* const device = page("device", tr("Device"), tr("The device, its switch, and its check"));
  this->addHand(device);
  this->addGroup(device, new pqHapticCheckGroup);
  this->addGroup(page("view", tr("View"), tr("The hand in the view")), new pqHapticViewGroup);
  QVBoxLayout* const stability =
    page("stability", tr("Stability"), tr("Limits of stiffness and energy, and the servo"));
  this->addStability(stability);
  this->addServo(stability);
  this->addState(page("state", tr("State"), tr("Measured forces and energies")));
  this->addScene(page("scene", tr("Scene"), tr("The data as they are touched")));
}

QLayout* pqHapticPanel::Internals::searchRow(QWidget* panel)
{
  this->Search = new pqHapticSearch(panel);
  this->Help = new pqHapticMouseHelp(panel);
  this->Charts = new pqHapticCharts(panel);
  this->ChartsFold = new pqHapticFold(this->Charts, tr("Charts"), tr("Force, depth, lateness and energy over time"));
  auto* row = new QHBoxLayout;
  row->addWidget(this->Search, 1);
  row->addWidget(this->ChartsFold);
  row->addWidget(this->Help->fold());
  return row;
}

void pqHapticPanel::Internals::showFound()
{
  if (this->Search->active())
  {
    const int found = this->Search->apply(this->Pages->pages());
    this->Pages->setNote(found > 0 ? QString() : tr("No row has these words."));
  }
}

/// The rows are hidden as their own state has it once the search is over, when they are refreshed.
void pqHapticPanel::Internals::searched()
{
  this->Search->restore();
  this->Pages->setNote(QString());
  this->Pages->showAll(this->Search->active());
}

/// Settings can change without a frame, from a script.
void pqHapticPanel::Internals::followMaterials(vtkHapticSession& session, pqHapticViewFollower& follower)
{
  if (this->Material->isVisible()) // looking at all sources costs too much for a hidden page
  {
    this->Material->setArrayNames(follower.arrayNames());
  }
  if (this->Main->isVisible() && this->Refreshes++ % refreshesInSecond == 0)
  {
    this->Main->setArrayNames(follower.shownArrays());
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
  constexpr int margin = 4; // [pixels]
  this->Widgets = std::make_unique<Internals>();
  this->setObjectName("pqHapticPanel");
  this->setWindowTitle(tr("Haptics"));
  auto* panel = new QWidget(this);
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(margin, margin, margin, margin);
  column->setSpacing(margin);
  Internals& w = *this->Widgets;
  w.Top = new pqHapticTop(panel);
  column->addWidget(w.Top);
  column->addLayout(w.searchRow(panel));
  w.Pages = new pqHapticPages(panel);
  column->addWidget(w.Pages, 1);
  column->addWidget(w.Help); // below the rows, which stay where they are when it is folded
  column->addWidget(w.Charts);
  w.fillPages();
  w.setTabOrder();
  new pqHapticGlossary(panel);
  this->setWidget(panel);
  this->connect(w.Pages, &pqHapticPages::chosen, w.Search, &QLineEdit::clear);
  this->connect(w.Pages, &pqHapticPages::chosen, this, &pqHapticPanel::refresh);
  this->connect(w.Search, &QLineEdit::textChanged, this,
    [this]
    {
      this->Widgets->searched();
      this->refresh();
    });

  auto* controller = pqHapticController::instance();
  this->connect(controller, &pqHapticController::sessionChanged, this, &pqHapticPanel::setProxy);
  this->connect(&w.Refresh, &QTimer::timeout, this, &pqHapticPanel::refresh);
  this->setProxy(controller->sessionProxy());
  w.Refresh.start(refreshPeriod_ms);
}

void pqHapticPanel::setProxy(vtkSMProxy* proxy)
{
  Internals& w = *this->Widgets;
  w.Links.clear();
  w.Charts->clear();
  w.DeviceRows->setProxy(proxy);
  w.Top->setProxy(proxy, w.Links);
  w.Main->setProxy(proxy, w.Links);
  for (QWidget* page : w.Pages->pages())
  {
    page->setEnabled(proxy != nullptr);
  }
  if (!proxy)
  {
    this->refresh();
    return;
  }
  pqHapticFill(w.Hand, proxy->GetProperty("Hand"));
  pqHapticLink::add(w.Links, w.Hand, "currentText", SIGNAL(currentTextChanged(const QString&)), proxy, "Hand");
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
  w.Unit.refresh(*this, session, *controller->follower());
  w.Pages->fitWidth();
  w.Top->refresh(session);
  w.Help->refresh(session);
  w.Charts->refresh(session, controller->follower()->report());
  w.Main->refresh(session);
  w.Place->refresh(session);
  w.Marks->refresh(session);
  w.Pages->setReasons(pqHapticPageReasons(session));
  w.showMeasured(session, *controller->follower());
  w.showFound();
}

void pqHapticPanel::Internals::showMeasured(vtkHapticSession* session, const pqHapticViewFollower& follower)
{
  for (pqHapticGroup* const group : this->Groups)
  {
    if (group->isVisible())
    {
      group->refresh(session);
    }
  }
  this->DeviceRows->refresh(session);
  this->Hand->setEnabled(session && session->GetDeviceTakesHand());
  const pqHapticReadout now = session ? pqHapticReadout::of(*session) : pqHapticReadout();
  for (const Readout& readout : this->Readouts)
  {
    if (readout.Label->isVisible())
    {
      readout.Label->setText(pqHapticInUnits(now.*readout.Text));
    }
  }
  pqHapticSay(this->Reason, now.Reason);
  const QString scene = this->Unit.sentence() + "\n" + pqHapticInUnits(follower.report() + now.Scene);
  if (this->Scene->isVisible() && scene != this->Scene->toPlainText())
  {
    this->Scene->setPlainText(scene);
  }
}
