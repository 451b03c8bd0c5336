// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticStrip.h"

#include "pqHapticNumberText.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace
{
constexpr std::size_t mostValues = 100; // ten seconds at ten a second
constexpr int margin = 3;               // [pixels]
constexpr double linesHigh = 2.5;       // of text: one to read, the rest for the curve below it
constexpr int shownDecimals = 2;        // a hand feels no hundredth of a newton, a millimetre or a millijoule

void Keep(double value, std::deque<double>& values)
{
  values.push_back(value);
  if (values.size() > mostValues)
  {
    values.pop_front();
  }
}

QString Labelled(double value)
{
  return pqHapticNumberText(value, shownDecimals);
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
  Keep(value, this->Values);
  this->Over = false;
  this->setAccessibleDescription(this->sentence());
  this->Painted = !this->Painted; // five pictures a second are seen to move, and painting is most of the cost of a
                                  // strip
  if (this->Painted)
  {
    this->update();
  }
}

void pqHapticStrip::addAt(double value, double along)
{
  Keep(along, this->Along);
  this->add(value);
}

void pqHapticStrip::setLast()
{
  if (!this->Over && !this->Values.empty())
  {
    this->Over = true;
    this->setAccessibleDescription(this->sentence());
    this->update();
  }
}

void pqHapticStrip::clear()
{
  if (!this->Values.empty())
  {
    this->Values.clear();
    this->Along.clear();
    this->Over = false;
    this->setAccessibleDescription(this->sentence());
    this->update();
  }
}

double pqHapticStrip::low() const
{
  return this->Values.empty() ? 0.0 : std::min(0.0, *std::min_element(this->Values.begin(), this->Values.end()));
}

double pqHapticStrip::high() const
{
  const double most = this->Values.empty() ? 0.0 : *std::max_element(this->Values.begin(), this->Values.end());
  return std::max(this->low() + this->Least, most);
}

QString pqHapticStrip::scale() const
{
  return tr("to %1 %2").arg(Labelled(this->high()), this->Unit);
}

QString pqHapticStrip::sentence() const
{
  if (this->Values.empty())
  {
    return tr("%1: none").arg(this->Title);
  }
  const QString value = Labelled(this->Values.back()) + " " + this->Unit;
  return (this->Over ? tr("%1, last: %2") : tr("%1: %2")).arg(this->Title, value);
}

QSize pqHapticStrip::sizeHint() const
{
  return { 0, static_cast<int>(linesHigh * this->fontMetrics().height()) + 2 * margin };
}

QSize pqHapticStrip::minimumSizeHint() const
{
  return this->sizeHint();
}

double pqHapticStrip::across(std::size_t value) const
{
  if (this->Along.empty())
  {
    return 1.0 - static_cast<double>(this->Values.size() - 1 - value) / (mostValues - 1);
  }
  const auto [low, high] = std::minmax_element(this->Along.begin(), this->Along.end());
  return *high > *low ? (this->Along[value] - *low) / (*high - *low) : 0.0;
}

void pqHapticStrip::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(this->rect(), this->palette().color(QPalette::Base));
  const QRectF words = QRectF(this->rect()).adjusted(margin, margin, -margin, -margin);
  const QRectF area = words.adjusted(0, this->fontMetrics().height(), 0, 0);
  const double low = this->low(), high = this->high();
  QPainterPath line;
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    const QPointF at(area.left() + this->across(i) * area.width(),
      area.bottom() - (this->Values[i] - low) / (high - low) * area.height());
    i == 0 ? line.moveTo(at) : line.lineTo(at);
  }
  painter.setPen(QPen(this->palette().color(QPalette::Highlight), 1.5));
  painter.drawPath(line);
  painter.setPen(this->palette().color(QPalette::Text));
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop, this->sentence());
  painter.drawText(words, Qt::AlignRight | Qt::AlignTop, this->scale());
}
