// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticLines.h"

#include "pqHapticUnits.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QPainter>
#include <QTextLayout>

pqHapticLines::pqHapticLines(QWidget* parent, const char* name, const QString& tip, int lines)
  : Superclass(parent), Tip(tip), Lines(lines)
{
  this->setObjectName(name);
  this->setToolTip(tip);
  this->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* copy = new QAction(tr("Copy"), this);
  this->addAction(copy);
  this->setContextMenuPolicy(Qt::ActionsContextMenu);
  this->connect(copy, &QAction::triggered, this, [this] { QApplication::clipboard()->setText(this->text()); });
}

pqHapticLines::~pqHapticLines() = default;

void pqHapticLines::say(const QString& said)
{
  const QString text = pqHapticInUnits(said);
  if (text != this->text())
  {
    this->setText(text);
    this->describe();
  }
}

QSize pqHapticLines::sizeHint() const
{
  return { 1, (this->Lines - 1) * this->fontMetrics().lineSpacing() + this->fontMetrics().height() };
}

QSize pqHapticLines::minimumSizeHint() const
{
  return this->sizeHint();
}

QStringList pqHapticLines::shown(bool& whole) const
{
  whole = true;
  QString text = this->text();
  QTextLayout layout(text.replace('\n', QChar::LineSeparator), this->font());
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  layout.beginLayout();
  QStringList lines;
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine())
  {
    if (lines.size() == this->Lines)
    {
      whole = false;
      const int last = layout.lineAt(this->Lines - 1).textStart();
      const QString rest = text.mid(last).replace(QChar::LineSeparator, ' ');
      lines.back() = this->fontMetrics().elidedText(rest, Qt::ElideRight, this->width());
      break;
    }
    line.setLineWidth(this->width());
    lines << text.mid(line.textStart(), line.textLength()).remove(QChar::LineSeparator);
  }
  layout.endLayout();
  return lines;
}

void pqHapticLines::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setPen(this->palette().color(this->foregroundRole()));
  int y = this->fontMetrics().ascent();
  bool whole = true;
  for (const QString& line : this->shown(whole))
  {
    painter.drawText(0, y, line);
    y += this->fontMetrics().lineSpacing();
  }
}

void pqHapticLines::describe()
{
  bool whole = true;
  this->shown(whole);
  this->setToolTip(whole ? this->Tip : this->text() + "\n\n" + this->Tip);
  this->setAccessibleDescription(this->text());
}

void pqHapticLines::resizeEvent(QResizeEvent* event)
{
  this->Superclass::resizeEvent(event);
  this->describe();
}

void pqHapticLines::changeEvent(QEvent* event)
{
  this->Superclass::changeEvent(event);
  if (event->type() == QEvent::FontChange)
  {
    this->updateGeometry();
    this->describe();
  }
}
