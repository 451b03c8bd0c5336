// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticLabel_h
#define pqHapticLabel_h

#include "pqHapticUnits.h"

#include <QLabel>
#include <QString>

/// A text of the panel that can be selected, wraps and has an explaining tip.
inline QLabel* pqHapticLabel(QWidget* parent, const char* name, const QString& tip)
{
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setToolTip(tip);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

/// An empty label takes no space, and all lines of its text are visible: a form gives it as many as its
/// words would need in a wider one.
inline void pqHapticSay(QLabel* label, const QString& text)
{
  const QRect room(0, 0, label->width(), QWIDGETSIZE_MAX);
  label->setText(pqHapticInUnits(text));
  label->setMinimumHeight(label->fontMetrics().boundingRect(room, Qt::TextWordWrap, label->text()).height());
  label->setVisible(!text.isEmpty());
}

#endif
