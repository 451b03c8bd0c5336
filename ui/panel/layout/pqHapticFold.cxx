// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticFold.h"

pqHapticFold::pqHapticFold(QWidget* folded, const QString& title, const QString& tip)
  : Superclass(folded->parentWidget())
{
  this->setObjectName(folded->objectName() + "Button");
  this->setText(title);
  this->setToolTip(tip);
  this->setCheckable(true);
  this->setFocusPolicy(Qt::StrongFocus);
  folded->setVisible(false);
  this->connect(this, &QToolButton::toggled, folded, &QWidget::setVisible);
}
