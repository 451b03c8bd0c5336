// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticStrip.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace
{
constexpr std::size_t mostValues = 100; // ten seconds at ten a second
constexpr int margin = 3;               // [pixels]
constexpr double linesHigh = 2.5;       // of text: one to read, the rest for the curve below it
constexpr int significant = 3;

QString Number(double value)
{
  return QString::number(value, 'g', significant);
}
} // namespace

pqHapticStrip::pqHapticStrip(QWidget* parent, const char* name, const QString& title, const QString& unit, double least)
  : Superclass(parent), Title(title), Unit(unit), Least(least)
{
  this->setObjectName(name);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

pqHapticStrip::~pqHapticStrip() = default;

void pqHapticStrip::add(double value)
{
  this->Values.push_back(value);
  if (this->Values.size() > mostValues)
  {
    this->Values.pop_front();
  }
  this->setAccessibleDescription(this->sentence());
  this->Painted = !this->Painted; // five pictures a second are seen to move, and painting is most of what a strip costs
  if (this->Painted)
  {
    this->update();
  }
}

void pqHapticStrip::clear()
{
  if (!this->Values.empty())
  {
    this->Values.clear();
    this->setAccessibleDescription(this->sentence());
    this->update();
  }
}

QString pqHapticStrip::sentence() const
{
  return this->Title + ": " + (this->Values.empty() ? tr("none") : Number(this->Values.back()) + " " + this->Unit);
}

QSize pqHapticStrip::sizeHint() const
{
  return { 0, static_cast<int>(linesHigh * this->fontMetrics().height()) + 2 * margin };
}

QSize pqHapticStrip::minimumSizeHint() const
{
  return this->sizeHint();
}

void pqHapticStrip::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(this->rect(), this->palette().color(QPalette::Base));
  const QRectF words = QRectF(this->rect()).adjusted(margin, margin, -margin, -margin);
  const QRectF area = words.adjusted(0, this->fontMetrics().height(), 0, 0);
  const auto range = std::minmax_element(this->Values.begin(), this->Values.end());
  const double low = this->Values.empty() ? 0.0 : std::min(0.0, *range.first);
  const double high = std::max(low + this->Least, this->Values.empty() ? 0.0 : *range.second);
  QPainterPath line;
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    const double age = static_cast<double>(this->Values.size() - 1 - i) / (mostValues - 1);
    const QPointF at(
      area.right() - age * area.width(), area.bottom() - (this->Values[i] - low) / (high - low) * area.height());
    i == 0 ? line.moveTo(at) : line.lineTo(at);
  }
  painter.setPen(QPen(this->palette().color(QPalette::Highlight), 1.5));
  painter.drawPath(line);
  painter.setPen(this->palette().color(QPalette::Text));
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop, this->sentence());
  painter.drawText(words, Qt::AlignRight | Qt::AlignTop, tr("to %1 %2").arg(Number(high), this->Unit));
}
