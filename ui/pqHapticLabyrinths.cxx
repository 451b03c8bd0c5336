// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticLabyrinths.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqFileDialog.h"
#include "pqHapticController.h"
#include "pqObjectBuilder.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkHapticLabyrinth.h"
#include "vtkHapticSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>

#include <cmath>

namespace
{
constexpr int readOutEvery_ms = 100;

QPushButton* Button(QWidget* parent, const char* name, const QString& text)
{
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  return button;
}

QLabel* Label(QWidget* parent, const char* name)
{
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}
} // namespace

pqHapticLabyrinths::pqHapticLabyrinths(QWidget* parent)
  : Superclass(parent), Worlds(new QListWidget(this)), Hidden(new QCheckBox(tr("&Hide walls: by touch alone"), this)),
    Trace(new QCheckBox(tr("&Trace"), this)), State(Label(this, "state")), Time(Label(this, "time")),
    Place(Label(this, "place")), Message(Label(this, "message"))
{
  this->setObjectName("hapticLabyrinths");
  this->setWindowTitle(tr("Labyrinths"));
  this->Worlds->setObjectName("worlds");
  this->Hidden->setObjectName("hidden");
  this->Trace->setObjectName("trace");
  this->Trace->setToolTip(tr("Draws the way since the hand was let go"));
  QPushButton* const file = Button(this, "file", tr("&Own file..."));
  QPushButton* const play = Button(this, "play", tr("&Play"));
  QPushButton* const again = Button(this, "again", tr("Start &again"));
  QPushButton* const zoom = Button(this, "zoom", tr("&Zoom until it can be felt"));
  play->setDefault(true);
  auto* grid = new QGridLayout(this);
  grid->addWidget(this->Worlds, 0, 0, 1, 3);
  grid->addWidget(file, 1, 0);
  grid->addWidget(play, 1, 1);
  grid->addWidget(again, 1, 2);
  grid->addWidget(this->Hidden, 2, 0);
  grid->addWidget(this->Trace, 2, 1);
  grid->addWidget(zoom, 2, 2);
  grid->addWidget(this->State, 3, 0, 1, 2);
  grid->addWidget(this->Time, 3, 2);
  grid->addWidget(this->Place, 4, 0, 1, 3);
  grid->addWidget(this->Message, 5, 0, 1, 3);
  this->connect(file, &QPushButton::clicked, this, &pqHapticLabyrinths::chooseFile);
  this->connect(play, &QPushButton::clicked, this, &pqHapticLabyrinths::play);
  this->connect(again, &QPushButton::clicked, this, &pqHapticLabyrinths::again);
  this->connect(zoom, &QPushButton::clicked, this, &pqHapticLabyrinths::zoom);
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

pqPipelineSource* pqHapticLabyrinths::open(const QString& world)
{
  pqServer* const server = pqActiveObjects::instance().activeServer();
  pqView* const view = pqActiveObjects::instance().activeView();
  if (!server || !qobject_cast<pqRenderView*>(view))
  {
    this->Message->setText(tr("A labyrinth needs a render view: open one first."));
    return nullptr;
  }
  pqObjectBuilder* const builder = pqApplicationCore::instance()->getObjectBuilder();
  if (this->Source)
  {
    builder->destroy(this->Source);
  }
  this->Source = builder->createSource("sources", "HapticLabyrinth", server);
  vtkSMPropertyHelper(this->Source->getProxy(), "World").Set(world.toUtf8().constData());
  this->Source->getProxy()->UpdateVTKObjects();
  this->Source->updatePipeline();
  this->Source->setModifiedState(pqProxy::UNMODIFIED);
  this->Shown = builder->createDataRepresentation(this->Source->getOutputPort(0), view);
  view->resetDisplay();
  return this->Source;
}

void pqHapticLabyrinths::play()
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  const QListWidgetItem* const item = this->Worlds->currentItem();
  pqPipelineSource* const source = session && item ? this->open(item->text()) : nullptr;
  auto* const lines = source ? vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject()) : nullptr;
  if (!lines)
  {
    return;
  }
  session->EndLabyrinth();
  const bool maze = session->PlayLabyrinth(lines->GetOutputDataObject(0), item->text().toUtf8().constData());
  const QString begins = session->GetDeviceGivesForce()
                           ? tr("You are brought to the start, then let go.")
                           : tr("This device gives no force: go to the start yourself, there the game begins.");
  this->Message->setText(maze ? begins : QString(session->GetProblem()));
  this->tellProxy();
  this->hideWalls(this->Hidden->isChecked());
  pqHapticController::instance()->setTouching(true);
}

void pqHapticLabyrinths::tellProxy()
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  vtkSMProxy* const proxy = pqHapticController::instance()->sessionProxy();
  vtkSMPropertyHelper(proxy, "LinesAsWalls").Set(vtkHapticSession::On);
  vtkSMPropertyHelper(proxy, "Radius").Set(session->GetRadius());
  vtkSMPropertyHelper(proxy, "Scale").Set(session->GetScale());
  vtkSMPropertyHelper(proxy, "Offset").Set(session->GetOffset(), 3);
  proxy->UpdateVTKObjects();
}

void pqHapticLabyrinths::again()
{
  if (vtkHapticSession* const session = pqHapticController::instance()->session())
  {
    session->PlayAgain();
  }
}

/// Transparent, not invisible: what is not visible is not felt.
void pqHapticLabyrinths::hideWalls(bool hidden)
{
  if (this->Shown)
  {
    vtkSMPropertyHelper(this->Shown->getProxy(), "Opacity").Set(hidden ? 0.0 : 1.0);
    this->Shown->getProxy()->UpdateVTKObjects();
    this->Shown->renderViewEventually();
  }
}

void pqHapticLabyrinths::zoom()
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  if (!session || !this->Source)
  {
    this->Message->setText(tr("Play a labyrinth first."));
    return;
  }
  const double zoom = session->GetFeelableZoom();
  if (!std::isfinite(zoom))
  {
    this->Message->setText(tr("Nothing is felt without stiffness: set one first."));
    return;
  }
  this->Message->setText(zoom > 1.0 ? tr("Enlarged %1 times: corridors of %2 mm and more can be told apart.")
                                        .arg(zoom, 0, 'g', 3)
                                        .arg(1e3 * session->GetFeelableWidth(), 0, 'g', 3)
                                    : tr("Its corridors can be told apart as they are."));
  double offset[3];
  for (int i = 0; i < 3; ++i)
  {
    const double hand = session->GetHandPosition()[i];
    offset[i] = hand + (session->GetOffset()[i] - hand) / zoom; // the hand stays where it is
  }
  vtkSMProxy* const proxy = pqHapticController::instance()->sessionProxy();
  vtkSMPropertyHelper(proxy, "Scale").Set(session->GetScale() / zoom);
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
  const int wish = session->TakeLabyrinthWish(); // none is kept until the dialog is seen again
  if (!this->isVisible())
  {
    return;
  }
  this->grant(wish);
  this->followTrace();
  this->State->setText(session->GetLabyrinthText());
  this->Time->setText(tr("%1 s").arg(session->GetLabyrinthTime(), 0, 'f', 1));
  const double* const p = session->GetProxyPosition();
  this->Place->setText(tr("Where am I: %1, %2").arg(p[0], 0, 'f', 1).arg(p[1], 0, 'f', 1));
}

void pqHapticLabyrinths::grant(int wish)
{
  if (wish == vtkHapticSession::AgainWish)
  {
    this->again();
  }
  if (wish == vtkHapticSession::NextWish && this->Source) // whoever touches something else keeps it
  {
    this->Worlds->setCurrentRow((this->Worlds->currentRow() + 1) % this->Worlds->count());
    this->play();
  }
}

void pqHapticLabyrinths::followTrace()
{
  const QString phase = pqHapticController::instance()->session()->GetLabyrinthPhase();
  const bool finished = phase == "arrived" || phase == "rests";
  if (finished != this->Finished)
  {
    this->Finished = finished;
    this->Trace->setChecked(finished);
  }
}
