// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticLabyrinths.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqFileDialog.h"
#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "pqObjectBuilder.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkHapticGallery.h"
#include "vtkHapticLabyrinth.h"
#include "vtkHapticLabyrinthData.h"
#include "vtkHapticLabyrinthGame.h"
#include "vtkHapticSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>

#include <cmath>
#include <utility>

namespace
{
constexpr int readOutEvery_ms = 100;
/// Less than the smallest step of a colour on a screen.
constexpr double unseenOpacity = 1e-3;

/// The settings of a game.
constexpr const char* settings[] = { "LinesAsWalls", "Radius", "Scale", "Offset", "Rotation" };

QPushButton* Button(QWidget* parent, const char* name, const QString& text, const QString& tip)
{
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setToolTip(tip);
  return button;
}

QCheckBox* Check(QWidget* parent, const char* name, const QString& text, const QString& tip)
{
  auto* box = new QCheckBox(text, parent);
  box->setObjectName(name);
  box->setToolTip(tip);
  return box;
}

QDoubleSpinBox* CorridorBox(QWidget* parent)
{
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName("corridor");
  box->setRange(0.0, 1e9);
  box->setDecimals(4);
  box->setSuffix(QObject::tr(" u"));
  box->setSpecialValueText(QObject::tr("from the file, or else measured"));
  box->setToolTip(QObject::tr("Width of the corridors; the radius of the disc in the hand is 1/5 of the width"));
  return box;
}
} // namespace

pqHapticLabyrinths::pqHapticLabyrinths(QWidget* parent)
  : Superclass(parent), Worlds(new QListWidget(this)), Corridor(CorridorBox(this)),
    Hidden(Check(this, "hidden", tr("&Hide walls: touch only"), tr("The walls are invisible and can be touched"))),
    Trace(Check(this, "trace", tr("&Trace"), tr("Draw the path since the hand was released"))),
    State(pqHapticLabel(this, "state", tr("State of the game"))),
    Time(pqHapticLabel(this, "time", tr("Duration of the exploration"))),
    Place(pqHapticLabel(this, "place", tr("Position of the proxy in the plane, in scene units"))),
    Message(pqHapticLabel(this, "message", tr("Last event and next step")))
{
  this->setObjectName("hapticLabyrinths");
  this->setWindowTitle(tr("Labyrinths"));
  this->Worlds->setObjectName("worlds");
  this->Worlds->setToolTip(tr("Gallery and user files; Enter plays the selected one"));
  QPushButton* const file =
    Button(this, "file", tr("&Own file..."), tr("Add a drawing (svg), a picture (png) or lines (vtp)"));
  QPushButton* const play = Button(this, "play", tr("&Play"), tr("Open the labyrinth and guide the hand to its start"));
  QPushButton* const again =
    Button(this, "again", tr("Start &again"), tr("Show the whole labyrinth and guide the hand to its start"));
  QPushButton* const zoom = Button(this, "zoom", tr("&Zoom until it can be felt"),
    tr("Enlarge the labyrinth about the hand until neighbouring corridors are distinguishable by touch"));
  QPushButton* const end =
    Button(this, "end", tr("&End the game"), tr("Restore proxy radius, scale and position from before the game"));
  auto* const corridors = new QLabel(tr("&Corridors"), this);
  corridors->setBuddy(this->Corridor);
  play->setDefault(true);
  auto* grid = new QGridLayout(this);
  grid->addWidget(this->Worlds, 0, 0, 1, 3);
  grid->addWidget(corridors, 1, 0);
  grid->addWidget(this->Corridor, 1, 1, 1, 2);
  grid->addWidget(file, 2, 0);
  grid->addWidget(play, 2, 1);
  grid->addWidget(again, 2, 2);
  grid->addWidget(this->Hidden, 3, 0);
  grid->addWidget(this->Trace, 3, 1);
  grid->addWidget(zoom, 3, 2);
  grid->addWidget(this->State, 4, 0);
  grid->addWidget(this->Time, 4, 1);
  grid->addWidget(end, 4, 2);
  grid->addWidget(this->Place, 5, 0, 1, 3);
  grid->addWidget(this->Message, 6, 0, 1, 3);
  this->connect(file, &QPushButton::clicked, this, &pqHapticLabyrinths::chooseFile);
  this->connect(play, &QPushButton::clicked, this, &pqHapticLabyrinths::play);
  this->connect(again, &QPushButton::clicked, this, &pqHapticLabyrinths::again);
  this->connect(zoom, &QPushButton::clicked, this, &pqHapticLabyrinths::zoom);
  this->connect(end, &QPushButton::clicked, this, &pqHapticLabyrinths::end);
  this->connect(this, &QDialog::finished, this, &pqHapticLabyrinths::end);
  this->connect(
    pqHapticController::instance(), &pqHapticController::sessionChanged, this, &pqHapticLabyrinths::forgetSettings);
  this->connect(this->Worlds, &QListWidget::itemActivated, this, &pqHapticLabyrinths::play);
  this->connect(this->Hidden, &QCheckBox::toggled, this, &pqHapticLabyrinths::hideWalls);
  this->connect(this->Trace, &QCheckBox::toggled, pqHapticController::instance(), &pqHapticController::showTrace);
  auto* timer = new QTimer(this);
  this->connect(timer, &QTimer::timeout, this, &pqHapticLabyrinths::readOut);
  timer->start(readOutEvery_ms);
  this->list();
}

void pqHapticLabyrinths::list()
{
  for (int i = 0; i < vtkHapticLabyrinth::GetNumberOfWorlds(); ++i)
  {
    this->Worlds->addItem(QString::fromStdString(vtkHapticLabyrinth::GetWorldName(i)));
  }
  this->Worlds->setCurrentRow(0);
}

void pqHapticLabyrinths::chooseFile()
{
  pqFileDialog dialog(nullptr, this, tr("A plane world of your own"), QString(), tr("Lines (*.vtp *.svg *.png)"));
  dialog.setFileMode(pqFileDialog::ExistingFile);
  if (dialog.exec() == QDialog::Accepted && !dialog.getSelectedFiles().isEmpty())
  {
    this->Worlds->addItem(dialog.getSelectedFiles().front());
    this->Worlds->setCurrentRow(this->Worlds->count() - 1);
  }
}

QString pqHapticLabyrinths::refusal(const QString& world) const
{
  if (world.isEmpty())
  {
    return tr("Choose a labyrinth in the list, or a file of your own.");
  }
  if (!pqHapticController::instance()->session() || !pqActiveObjects::instance().activeServer())
  {
    return tr("There is no haptic session: connect to a server first.");
  }
  if (!qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView()))
  {
    return tr("A labyrinth needs a render view: open one first.");
  }
  const std::string file = vtkHapticGallery::FileOf(world.toStdString());
  const double corridor_u = this->Corridor->value();
  return QString::fromStdString(
    vtkHapticReadLabyrinth(file, corridor_u > 0.0 ? std::optional(corridor_u) : std::nullopt).Problem);
}

/// One source for all games, so that filters on it and its place in the pipeline stay.
void pqHapticLabyrinths::openWorld(const QString& world)
{
  pqObjectBuilder* const builder = pqApplicationCore::instance()->getObjectBuilder();
  this->hideWalls(false); // where it was shown until now
  if (!this->Source)
  {
    this->Source = builder->createSource("sources", "HapticLabyrinth", pqActiveObjects::instance().activeServer());
    this->connect(this->Source, &QObject::destroyed, this, &pqHapticLabyrinths::end);
  }
  vtkSMPropertyHelper(this->Source->getProxy(), "World").Set(world.toUtf8().constData());
  vtkSMPropertyHelper(this->Source->getProxy(), "Corridor").Set(this->Corridor->value());
  this->Source->getProxy()->UpdateVTKObjects();
  this->Source->updatePipeline();
  this->Source->setModifiedState(pqProxy::UNMODIFIED);
  pqView* const view = pqActiveObjects::instance().activeView();
  this->Shown = this->Source->getRepresentation(0, view);
  this->Shown =
    this->Shown ? this->Shown.data() : builder->createDataRepresentation(this->Source->getOutputPort(0), view);
  this->Shown->setVisible(true);
  view->forceRender(); // until it is drawn the view has the bounds of the one before
  view->resetDisplay();
}

void pqHapticLabyrinths::play()
{
  const QListWidgetItem* const item = this->Worlds->currentItem();
  const QString world = item ? item->text() : QString();
  const QString refused = this->refusal(world);
  if (!refused.isEmpty())
  {
    this->Message->setText(refused);
    return;
  }
  this->openWorld(world);
  this->begin();
}

void pqHapticLabyrinths::begin()
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  auto* const lines = vtkAlgorithm::SafeDownCast(this->Source->getProxy()->GetClientSideObject());
  if (!session || !lines)
  {
    this->Message->setText(
      tr("A labyrinth needs the built-in server of ParaView: disconnect from the remote server first."));
    return;
  }
  const std::string world = vtkSMPropertyHelper(this->Source->getProxy(), "World").GetAsString();
  const std::string problem = vtkHapticToLabyrinth(lines->GetOutputDataObject(0), world).Problem;
  if (!problem.empty()) // the source may be another one than was played, from its own properties
  {
    this->Message->setText(QString::fromStdString(problem));
    return;
  }
  this->keepSettings();
  this->hideWalls(this->Hidden->isChecked());
  const bool maze = session->GetLabyrinth()->Play(lines->GetOutputDataObject(0), world.c_str());
  const QString begins = session->GetDeviceGivesForce()
                           ? tr("The device guides your hand to the start, then releases it.")
                           : tr("This device renders no force: move to the start yourself to begin the game.");
  this->Message->setText(maze ? begins : QString(session->GetProblem()));
  pqHapticController::instance()->setTouching(true);
}

void pqHapticLabyrinths::keepSettings()
{
  vtkSMProxy* const proxy = pqHapticController::instance()->sessionProxy();
  if (!this->Before.empty())
  {
    return;
  }
  for (const char* name : settings)
  {
    const vtkSMPropertyHelper property(proxy, name);
    for (unsigned int i = 0; i < property.GetNumberOfElements(); ++i)
    {
      this->Before.push_back({ name, i, property.GetAsDouble(i) });
    }
  }
}

void pqHapticLabyrinths::forgetSettings()
{
  this->Before.clear();
}

void pqHapticLabyrinths::again()
{
  if (!this->Source)
  {
    this->Message->setText(tr("Play a labyrinth first."));
    return;
  }
  this->begin();
}

void pqHapticLabyrinths::end()
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  const std::vector<Setting> before = std::exchange(this->Before, {});
  if (!session || before.empty())
  {
    return;
  }
  session->GetLabyrinth()->End();
  vtkSMProxy* const proxy = pqHapticController::instance()->sessionProxy();
  for (const Setting& setting : before)
  {
    vtkSMPropertyHelper(proxy, setting.Name).Set(setting.Element, setting.Value);
  }
  proxy->UpdateVTKObjects();
  this->hideWalls(false);
  this->Message->setText(tr("The game is over: proxy radius, scale and position are restored."));
}

/// Too transparent to be seen, yet not wholly: an invisible surface is not felt.
void pqHapticLabyrinths::hideWalls(bool hidden)
{
  pqHapticController::instance()->showPlaces(!hidden);
  if (!this->Shown)
  {
    this->Opacity.reset();
  }
  else if (hidden != this->Opacity.has_value())
  {
    vtkSMPropertyHelper opacity(this->Shown->getProxy(), "Opacity");
    const double before = std::exchange(this->Opacity, std::nullopt).value_or(unseenOpacity);
    if (hidden)
    {
      this->Opacity = opacity.GetAsDouble();
    }
    opacity.Set(before);
    this->Shown->getProxy()->UpdateVTKObjects();
    this->Shown->renderViewEventually();
  }
}

void pqHapticLabyrinths::zoom()
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  if (!session || this->Before.empty())
  {
    this->Message->setText(tr("Play a labyrinth first."));
    return;
  }
  const double zoom = session->GetLabyrinth()->GetFeelableZoom();
  if (!std::isfinite(zoom))
  {
    this->Message->setText(tr("The stiffness is 0, so that there is no force: set a stiffness first."));
    return;
  }
  this->Message->setText(zoom > 1.0 ? tr("Enlarged %1 times: corridors from %2 mm on are distinguishable.")
                                        .arg(zoom, 0, 'g', 3)
                                        .arg(1e3 * session->GetLabyrinth()->GetFeelableWidth(), 0, 'g', 3)
                                    : tr("The corridors are distinguishable without enlargement."));
  double offset[3];
  for (int i = 0; i < 3; ++i)
  {
    const double hand = session->GetHandPosition()[i];
    offset[i] = hand + (session->GetSettingNumbers("Offset")[i] - hand) / zoom; // the hand stays where it is
  }
  vtkSMProxy* const proxy = pqHapticController::instance()->sessionProxy();
  vtkSMPropertyHelper(proxy, "Scale").Set(session->GetSetting("Scale") / zoom);
  vtkSMPropertyHelper(proxy, "Offset").Set(offset, 3);
  proxy->UpdateVTKObjects();
}

void pqHapticLabyrinths::readOut()
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  if (!session)
  {
    return;
  }
  const int wish = session->GetLabyrinth()->TakeWish(); // none is kept until the dialog is seen again
  if (!this->isVisible())
  {
    return;
  }
  this->grant(wish);
  this->followTrace();
  this->State->setText(session->GetLabyrinth()->GetText());
  this->Time->setText(tr("%1 s").arg(session->GetLabyrinth()->GetTime(), 0, 'f', 1));
  const double* const p = session->GetProxyPosition();
  this->Place->setText(tr("Where am I: %1, %2 u").arg(p[0], 0, 'g', 4).arg(p[1], 0, 'g', 4));
}

void pqHapticLabyrinths::grant(int wish)
{
  if (wish > 0 && wish <= this->Worlds->count() && this->Source) // a person who touches something else keeps it
  {
    this->Worlds->setCurrentRow(wish - 1);
    this->play();
  }
}

void pqHapticLabyrinths::followTrace()
{
  const QString phase = pqHapticController::instance()->session()->GetLabyrinth()->GetPhase();
  const bool finished = phase == "arrived" || phase == "rests";
  const bool begun = phase == "leads" || phase == "lets go" || phase == "explores";
  if (finished && !std::exchange(this->Finished, true))
  {
    this->Showed = !this->Trace->isChecked();
    this->Trace->setChecked(true);
  }
  else if (begun && std::exchange(this->Finished, false) && this->Showed)
  {
    this->Trace->setChecked(false);
  }
}
