// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticMarksGroup.h"

#include "pqFileDialog.h"
#include "pqHapticButton.h"
#include "pqHapticController.h"
#include "pqHapticLabel.h"
#include "vtkHapticInspection.h"
#include "vtkHapticMessageCapture.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkSMProxy.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPlainTextEdit>

namespace
{
constexpr int listHeight = 80; // of four marks [pixels]

QString StateOf(vtkHapticSession& session, int mark)
{
  const int state = session.GetInspection()->GetMarkState(mark);
  return state == vtkHapticInspection::MarkStale    ? QObject::tr(" - stale: the source has changed or moved")
         : state == vtkHapticInspection::MarkUnseen ? QObject::tr(" - the source is not touched")
                                                    : QString();
}

QStringList LinesOf(vtkHapticSession& session)
{
  vtkNew<vtkTable> table;
  session.GetInspection()->GetMarksTable(table);
  QStringList lines;
  for (int mark = 0; mark < session.GetNumberOfMarks(); ++mark)
  {
    const auto of = [&](const char* column)
    { return QString::number(table->GetValueByName(mark, column).ToDouble(), 'g', 6); };
    lines << QString("%1  %2 at (%3, %4, %5) u%6")
               .arg(mark + 1)
               .arg(QString::fromStdString(table->GetValueByName(mark, "Source").ToString()), of("X"), of("Y"), of("Z"),
                 StateOf(session, mark));
  }
  return lines;
}
} // namespace

pqHapticMarksGroup::pqHapticMarksGroup(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("marksGroup");
  const QAction* const action = pqHapticController::instance()->markAction();
  this->Mark = pqHapticButton(this, "mark", tr("Mark"),
    QString("%1 (%2)").arg(action->toolTip(), action->shortcut().toString(QKeySequence::NativeText)));
  this->Save = pqHapticButton(this, "saveMarks", tr("Save Marks..."), tr("Write the marks as csv or vtp"));
  this->Clear = pqHapticButton(this, "clearMarks", tr("Clear"), tr("Remove all marks"));
  this->Count = pqHapticLabel(this, "markCount", tr("Number of marks"));
  this->Marks = new QPlainTextEdit(this);
  this->Marks->setObjectName("marks");
  this->Marks->setReadOnly(true);
  this->Marks->setTabChangesFocus(true);
  this->Marks->setToolTip(
    tr("Number, source and position of each mark, and its validity (stale after a change of the source)"));
  this->Marks->setMaximumHeight(listHeight);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : { this->Mark, this->Save, this->Clear })
  {
    buttons->addWidget(button, 1);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(buttons);
  column->addWidget(this->Count);
  column->addWidget(this->Marks);
  this->connect(this->Mark, &QPushButton::clicked, action, &QAction::trigger);
  this->connect(this->Save, &QPushButton::clicked, this, &pqHapticMarksGroup::save);
  this->connect(this->Clear, &QPushButton::clicked, this, &pqHapticMarksGroup::clear);
  this->refresh(nullptr);
}

void pqHapticMarksGroup::refresh(vtkHapticSession* session)
{
  const int count = session ? session->GetNumberOfMarks() : 0;
  this->Mark->setEnabled(session != nullptr);
  this->Save->setEnabled(count > 0);
  this->Clear->setEnabled(count > 0);
  this->Count->setText(count == 0 ? tr("No marks.") : count == 1 ? tr("1 mark:") : tr("%1 marks:").arg(count));
  this->Marks->setVisible(count > 0);
  if (!this->isVisible())
  {
    return;
  }
  const QStringList lines = session ? LinesOf(*session) : QStringList();
  if (const QString text = lines.join("\n"); text != this->Marks->toPlainText())
  {
    this->Marks->setPlainText(text);
  }
}

QList<QWidget*> pqHapticMarksGroup::fields() const
{
  return { this->Mark, this->Save, this->Clear, this->Marks };
}

void pqHapticMarksGroup::save()
{
  pqFileDialog dialog(nullptr, this, tr("Save Marks"), QString(), tr("Marks as text (*.csv);;Marks as points (*.vtp)"));
  dialog.setObjectName("FileSaveMarks");
  dialog.setFileMode(pqFileDialog::AnyFile);
  vtkHapticSession* session = pqHapticController::instance()->session();
  if (session && dialog.exec() == QDialog::Accepted && !dialog.getSelectedFiles().empty())
  {
    const vtkHapticMessageCapture saidByThePanel; // else ParaView's messages open over it
    session->GetInspection()->WriteMarks(dialog.getSelectedFiles().first().toUtf8().constData());
  }
}

void pqHapticMarksGroup::clear()
{
  if (vtkSMProxy* proxy = pqHapticController::instance()->sessionProxy())
  {
    proxy->InvokeCommand("ClearMarks");
  }
}
