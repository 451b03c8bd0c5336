// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticNumber_h
#define pqHapticNumber_h

#include <QDoubleSpinBox>
#include <QString>

/// What the core accepts [1].
inline constexpr double pqHapticLargestFriction = 10.0;

/// A number of the panel: it takes effect once it is typed, and its tip says what it is.
inline QDoubleSpinBox* pqHapticNumber(
  QWidget* parent, const QString& name, double low, double high, int decimals, const QString& tip)
{
  constexpr int leastWidth = 90; // else the widest number a field could hold makes the whole panel wide [pixels]
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(low, high);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setKeyboardTracking(false);
  box->setMinimumWidth(leastWidth);
  box->setToolTip(tip);
  return box;
}

#endif
