// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticButton_h
#define pqHapticButton_h

#include <QHBoxLayout>
#include <QPushButton>
#include <QString>

/// A button of the panel, with the name that tests find the button by.
inline QPushButton* pqHapticButton(QWidget* parent, const char* name, const QString& text, const QString& tip)
{
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  button->setToolTip(tip);
  return button;
}

/// One of several in a row, as wide as the others.
inline QPushButton* pqHapticButton(QHBoxLayout* row, const char* name, const QString& text, const QString& tip)
{
  QPushButton* const button = pqHapticButton(static_cast<QWidget*>(nullptr), name, text, tip);
  row->addWidget(button, 1);
  return button;
}

#endif
