// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticLabel_h
#define pqHapticLabel_h

#include <QLabel>
#include <QString>

/// A text of the panel that can be selected, wraps and says in its tip what it is.
inline QLabel* pqHapticLabel(QWidget* parent, const char* name, const QString& tip)
{
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setToolTip(tip);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

/// A label with nothing to say takes no room, and all lines of what it says are seen: a form gives it as many as its
/// words would need in a wider one.
inline void pqHapticSay(QLabel* label, const QString& text)
{
  const QRect room(0, 0, label->width(), QWIDGETSIZE_MAX);
  label->setText(text);
  label->setMinimumHeight(label->fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height());
  label->setVisible(!text.isEmpty());
}

#endif
