// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticQuantityBox.h"

#include "pqHapticNumberText.h"

#include <QRegularExpression>

#include <cmath>

namespace
{
constexpr int significant = 9;
/// A spin box rounds its value to so many decimals: all that a number can have.
constexpr int allDecimals = 323;
} // namespace

pqHapticQuantityBox::pqHapticQuantityBox(QWidget* parent) : pqHapticQuantityBox(allDecimals, parent) {}

pqHapticQuantityBox::pqHapticQuantityBox(int decimals, QWidget* parent) : Superclass(parent)
{
  this->setDecimals(decimals);
}

pqHapticQuantityBox::~pqHapticQuantityBox() = default;

bool pqHapticQuantityBox::isSpecial(const QString& text) const
{
  return !this->specialValueText().isEmpty() && text == this->specialValueText();
}

void pqHapticQuantityBox::setAutomatic(bool on)
{
  if (on != this->Automatic)
  {
    this->Automatic = on;
    this->setSpecialValueText(this->specialValueText()); // Qt then writes the text anew
  }
}

QString pqHapticQuantityBox::numberIn(const QString& text) const
{
  QString number = text.trimmed();
  if (number.endsWith(this->suffix().trimmed()))
  {
    number.chop(this->suffix().trimmed().size());
  }
  return number.trimmed();
}

QString pqHapticQuantityBox::textFromValue(double value) const
{
  if (this->Automatic)
  {
    return tr("automatic");
  }
  const double shown = this->Factor * value;
  return this->decimals() == allDecimals ? QString::number(shown, 'g', significant)
                                         : pqHapticNumberText(shown, this->decimals());
}

double pqHapticQuantityBox::valueFromText(const QString& text) const
{
  return this->isSpecial(text)                        ? this->minimum()
         : this->Automatic && text == tr("automatic") ? this->value()
                                                      : this->numberIn(text).toDouble() / this->Factor;
}

QValidator::State pqHapticQuantityBox::validate(QString& text, int&) const
{
  if (this->isSpecial(text) || (this->Automatic && text == tr("automatic")))
  {
    return QValidator::Acceptable;
  }
  const QString number = this->numberIn(text);
  bool isNumber = false;
  const double value = number.toDouble(&isNumber) / this->Factor;
  if (isNumber && std::isfinite(value))
  {
    return value >= this->minimum() && value <= this->maximum() ? QValidator::Acceptable : QValidator::Intermediate;
  }
  static const QRegularExpression begun(R"(^[-+]?[0-9]*\.?[0-9]*([eE][-+]?[0-9]*)?$)");
  return begun.match(number).hasMatch() ? QValidator::Intermediate : QValidator::Invalid;
}

void pqHapticQuantityBox::stepBy(int steps)
{
  if (this->decimals() != allDecimals)
  {
    this->Superclass::stepBy(steps);
    return;
  }
  const double now = std::abs(this->value());
  const double step = now > 0.0 ? std::pow(10.0, std::floor(std::log10(now)) - 1.0) : 1.0;
  this->setValue(this->value() + steps * step);
}
