// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticLabyrinths.h"

#include "haptics/force/FeatureSize.h"
#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqFileDialog.h"
#include "pqHapticController.h"
#include "pqObjectBuilder.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
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

#include <algorithm>

namespace
{
constexpr int readOutEvery_ms = 100;
constexpr double pressing_N = 1.0; // of a hand that explores

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

/// Width of the corridors of the labyrinth that a source gives [u]; 0 without one.
double CorridorOf(pqPipelineSource* source)
{
  auto* const lines = source ? vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject()) : nullptr;
  vtkDataObject* const data = lines ? lines->GetOutputDataObject(0) : nullptr;
  vtkDataArray* const array = data ? data->GetFieldData()->GetArray("Corridor") : nullptr;
  return array && array->GetNumberOfValues() > 0 ? array->GetComponent(0, 0) : 0.0;
}
} // namespace

pqHapticLabyrinths::pqHapticLabyrinths(QWidget* parent)
  : Superclass(parent), Worlds(new QListWidget(this)), Hidden(new QCheckBox(tr("&Hide walls: by touch alone"), this)),
    State(Label(this, "state")), Time(Label(this, "time")), Place(Label(this, "place")), Message(Label(this, "message"))
{
  this->setObjectName("hapticLabyrinths");
  this->setWindowTitle(tr("Labyrinths"));
  this->Worlds->setObjectName("worlds");
  this->Hidden->setObjectName("hidden");
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
  grid->addWidget(this->Hidden, 2, 0, 1, 2);
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
  this->Message->setText(maze ? tr("You are brought to the start, then let go.") : QString(session->GetProblem()));
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
  const double width_u = session ? CorridorOf(this->Source) : 0.0;
  if (!(width_u > 0.0))
  {
    this->Message->setText(tr("Play a labyrinth first."));
    return;
  }
  const double scale_u_per_m = session->GetScale();
  const double stiffness_N_per_m = std::min(session->GetStiffness(), session->GetLargestStiffness());
  const double zoom = palpate::zoomToFeel(width_u / scale_u_per_m, pressing_N, stiffness_N_per_m);
  this->Message->setText(zoom > 1.0 ? tr("Enlarged %1 times: corridors of %2 mm and more can be told apart.")
                                        .arg(zoom, 0, 'g', 3)
                                        .arg(1e3 * palpate::smallestFeature_m(pressing_N, stiffness_N_per_m), 0, 'g', 3)
                                    : tr("Its corridors can be told apart as they are."));
  double offset[3];
  for (int i = 0; i < 3; ++i)
  {
    const double hand = session->GetHandPosition()[i];
    offset[i] = hand + (session->GetOffset()[i] - hand) / zoom; // the hand stays where it is
  }
  vtkSMProxy* const proxy = pqHapticController::instance()->sessionProxy();
  vtkSMPropertyHelper(proxy, "Scale").Set(scale_u_per_m / zoom);
  vtkSMPropertyHelper(proxy, "Offset").Set(offset, 3);
  proxy->UpdateVTKObjects();
}

void pqHapticLabyrinths::readOut()
{
  vtkHapticSession* const session = pqHapticController::instance()->session();
  if (!session || !this->isVisible())
  {
    return;
  }
  this->State->setText(session->GetLabyrinthPhase());
  this->Time->setText(tr("%1 s").arg(session->GetLabyrinthTime(), 0, 'f', 1));
  const double* const p = session->GetProxyPosition();
  this->Place->setText(tr("Where am I: %1, %2").arg(p[0], 0, 'f', 1).arg(p[1], 0, 'f', 1));
}
