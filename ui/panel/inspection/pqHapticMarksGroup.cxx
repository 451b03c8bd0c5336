// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMarksGroup.h"

#include "pqFileDialog.h"
#include "pqHapticButton.h"
#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "pqHapticMarks.h"
#include "vtkHapticInspection.h"
#include "vtkHapticMessageCapture.h"
#include "vtkHapticSession.h"
#include "vtkSMProxy.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int ShownRows = 5; // the others are scrolled to
enum Column
{
  NameColumn,
  PositionColumn,
  ValidityColumn,
  Columns
};

vtkHapticSession* Session()
{
  return pqHapticController::instance()->session();
}

QString StateOf(vtkHapticSession& session, int mark)
{
  const int state = session.GetInspection()->GetMarkState(mark);
  return state == vtkHapticInspection::MarkStale    ? QObject::tr("stale: the source has changed or moved")
         : state == vtkHapticInspection::MarkUnseen ? QObject::tr("the source is not touched")
                                                    : QObject::tr("valid");
}

QString PositionOf(vtkHapticSession& session, int mark)
{
  double at[3];
  session.GetInspection()->GetMarkPosition(mark, at);
  const auto number = [](double value) { return QString::number(value, 'g', 6); };
  return pqHapticInUnits(QString("(%1, %2, %3) u").arg(number(at[0]), number(at[1]), number(at[2])));
}

double DistanceOf(vtkHapticSession& session, int one, int other)
{
  double a[3], b[3];
  session.GetInspection()->GetMarkPosition(one, a);
  session.GetInspection()->GetMarkPosition(other, b);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The file that a person chooses; "": none.
QByteArray FileOf(QWidget* parent, const char* name, const QString& title, const QString& types, bool present)
{
  pqFileDialog dialog(nullptr, parent, title, QString(), types);
  dialog.setObjectName(name);
  dialog.setFileMode(present ? pqFileDialog::ExistingFile : pqFileDialog::AnyFile);
  const bool taken = dialog.exec() == QDialog::Accepted && !dialog.getSelectedFiles().empty();
  return taken ? dialog.getSelectedFiles().first().toUtf8() : QByteArray();
}
} // namespace

QPushButton* pqHapticMarksGroup::button(QHBoxLayout* row, const char* name, const QString& title, const QString& tip)
{
  QPushButton* const made = pqHapticButton(this, name, title, tip);
  row->addWidget(made, 1);
  return made;
}

pqHapticMarksGroup::pqHapticMarksGroup(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("marksGroup");
  const QAction* const action = pqHapticController::instance()->markAction();
  auto* marks = new QHBoxLayout;
  this->Mark = this->button(marks, "mark", tr("Mark"),
    QString("%1 (%2)").arg(action->toolTip(), action->shortcut().toString(QKeySequence::NativeText)));
  this->Delete = this->button(marks, "deleteMarks", tr("Delete"), tr("Delete the chosen marks"));
  this->GoTo = this->button(marks, "goToMark", tr("Go To"), tr("Turn the camera to the chosen mark"));
  auto* files = new QHBoxLayout;
  this->Save = this->button(files, "saveMarks", tr("Save..."), tr("Write the marks as csv or vtp"));
  this->Load = this->button(files, "loadMarks", tr("Load..."), tr("Replace the marks by those of a csv file"));
  this->Clear = this->button(files, "clearMarks", tr("Clear"), tr("Remove all marks"));
  this->Count = pqHapticLabel(this, "markCount", tr("Number of marks"));
  this->Distance = pqHapticLabel(this, "markDistance", tr("Straight distance between the two chosen marks"));
  this->makeTable();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(marks);
  column->addLayout(files);
  column->addWidget(this->Count);
  column->addWidget(this->Marks);
  column->addWidget(this->Distance);
  this->connect(this->Mark, &QPushButton::clicked, action, &QAction::trigger);
  this->connect(this->Delete, &QPushButton::clicked, this, &pqHapticMarksGroup::remove);
  this->connect(this->GoTo, &QPushButton::clicked, this,
    [this] { pqHapticController::instance()->marks()->goTo(this->chosen().value(0, -1)); });
  this->connect(this->Save, &QPushButton::clicked, this, &pqHapticMarksGroup::save);
  this->connect(this->Load, &QPushButton::clicked, this, &pqHapticMarksGroup::load);
  this->connect(this->Clear, &QPushButton::clicked, this, &pqHapticMarksGroup::clear);
  this->refresh(nullptr);
}

void pqHapticMarksGroup::makeTable()
{
  this->Marks = new QTableWidget(0, Columns, this);
  this->Marks->setObjectName("marks");
  this->Marks->setToolTip(tr("Number, name, position and validity of each mark (stale after a change of the source). "
                             "A double click on the name changes it; two chosen marks have their distance below"));
  this->Marks->setHorizontalHeaderLabels({ tr("Name"), tr("Position"), tr("Validity") });
  this->Marks->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->Marks->horizontalHeader()->setSectionResizeMode(ValidityColumn, QHeaderView::Stretch);
  this->Marks->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Marks->setTabKeyNavigation(false); // the Tab key leads on to the next field
  this->Marks->setMinimumWidth(1);
  this->Marks->setFixedHeight((ShownRows + 1) * this->Marks->verticalHeader()->defaultSectionSize());
  this->connect(this->Marks, &QTableWidget::itemChanged, this, &pqHapticMarksGroup::rename);
  this->connect(this->Marks, &QTableWidget::itemSelectionChanged, this, &pqHapticMarksGroup::sayDistance);
}

QList<int> pqHapticMarksGroup::chosen() const
{
  QList<int> rows;
  for (const QModelIndex& index : this->Marks->selectionModel()->selectedIndexes())
  {
    rows << (rows.contains(index.row()) ? QList<int>() : QList<int>{ index.row() });
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

void pqHapticMarksGroup::sayDistance()
{
  const QList<int> rows = this->chosen();
  vtkHapticSession* const session = Session();
  this->Delete->setEnabled(session && !rows.isEmpty());
  this->GoTo->setEnabled(session && rows.size() == 1);
  const bool two = session && rows.size() == 2;
  pqHapticSay(this->Distance, two ? tr("Distance between %1 and %2: %3 u")
                                      .arg(rows[0] + 1)
                                      .arg(rows[1] + 1)
                                      .arg(DistanceOf(*session, rows[0], rows[1]), 0, 'g', 6)
                                  : QString());
}

/// The chosen rows stay chosen.
void pqHapticMarksGroup::fill(vtkHapticSession* session)
{
  const int count = session ? session->GetNumberOfMarks() : 0;
  QString wanted = session ? QString::fromUtf8(session->GetSettingText("MarksText")) : QString();
  for (int mark = 0; mark < count; ++mark)
  {
    wanted += StateOf(*session, mark);
  }
  if (wanted == this->Shown)
  {
    return;
  }
  this->Shown = wanted;
  const QSignalBlocker nothingWasTyped(this->Marks);
  this->Marks->setRowCount(count);
  for (int mark = 0; mark < count; ++mark)
  {
    const QString name = QString::fromStdString(session->GetInspection()->GetMarkName(mark));
    const QString texts[] = { name, PositionOf(*session, mark), StateOf(*session, mark) };
    for (int column = 0; column < Columns; ++column)
    {
      auto* const item = new QTableWidgetItem(texts[column]);
      item->setFlags(column == NameColumn ? item->flags() : item->flags() & ~Qt::ItemIsEditable);
      this->Marks->setItem(mark, column, item);
    }
  }
}

void pqHapticMarksGroup::refresh(vtkHapticSession* session)
{
  const int count = session ? session->GetNumberOfMarks() : 0;
  this->Mark->setEnabled(session != nullptr);
  this->Save->setEnabled(count > 0);
  this->Load->setEnabled(session != nullptr);
  this->Clear->setEnabled(count > 0);
  this->Count->setText(count == 0 ? tr("No marks.") : count == 1 ? tr("1 mark:") : tr("%1 marks:").arg(count));
  for (QWidget* const widget : QList<QWidget*>{ this->Marks, this->Delete, this->GoTo })
  {
    widget->setVisible(count > 0);
  }
  if (this->isVisible())
  {
    this->fill(session);
  }
  this->sayDistance();
}

QList<QWidget*> pqHapticMarksGroup::fields() const
{
  return { this->Mark, this->Delete, this->GoTo, this->Save, this->Load, this->Clear, this->Marks };
}

void pqHapticMarksGroup::rename(QTableWidgetItem* item)
{
  if (Session() && item->column() == NameColumn)
  {
    Session()->GetInspection()->RenameMark(item->row(), item->text().toUtf8().constData());
  }
}

void pqHapticMarksGroup::remove()
{
  const QList<int> rows = this->chosen();
  for (auto row = rows.rbegin(); Session() && row != rows.rend(); ++row)
  {
    Session()->GetInspection()->RemoveMark(*row);
  }
  this->Marks->clearSelection();
}

void pqHapticMarksGroup::save()
{
  const QString types = tr("Marks as text (*.csv);;Marks as points (*.vtp)");
  const QByteArray file = FileOf(this, "FileSaveMarks", tr("Save Marks"), types, false);
  if (Session() && !file.isEmpty())
  {
    const vtkHapticMessageCapture saidByThePanel; // else ParaView's messages open over it
    Session()->GetInspection()->WriteMarks(file.constData());
  }
}

void pqHapticMarksGroup::load()
{
  const QByteArray file = FileOf(this, "FileLoadMarks", tr("Load Marks"), tr("Marks as text (*.csv)"), true);
  if (Session() && !file.isEmpty())
  {
    const vtkHapticMessageCapture saidByThePanel;
    Session()->GetInspection()->ReadMarks(file.constData());
  }
}

void pqHapticMarksGroup::clear()
{
  if (vtkSMProxy* proxy = pqHapticController::instance()->sessionProxy())
  {
    proxy->InvokeCommand("ClearMarks");
  }
}
