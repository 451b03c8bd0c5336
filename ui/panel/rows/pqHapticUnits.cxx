// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticUnits.h"

#include <QRegularExpression>

namespace
{
QString& Unit()
{
  static QString unit("u");
  return unit;
}
} // namespace

bool pqHapticSetLengthUnit(const QString& unit)
{
  const bool another = unit != Unit();
  Unit() = unit;
  return another;
}

QString pqHapticInUnits(QString text)
{
  static const QRegularExpression quantity(R"(([0-9)]) u(?![A-Za-z0-9_]))");
  return Unit() == "u" ? text : text.replace(quantity, "\\1 " + Unit());
}

QString pqHapticUnitIn(QString unit)
{
  static const QRegularExpression length(R"(\bu\b)");
  return unit.replace(length, Unit());
}
