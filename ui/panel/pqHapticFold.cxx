// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticFold.h"

#include <QVBoxLayout>

pqHapticFold::pqHapticFold(QVBoxLayout* column, const QString& name, const QString& title, const QString& tip)
  : Superclass(column->parentWidget()), Body(new QWidget(column->parentWidget())), Rows(new QVBoxLayout(Body))
{
  this->setObjectName(name + "Button");
  this->setText(title);
  this->setToolTip(tip);
  this->setCheckable(true);
  this->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  this->setArrowType(Qt::RightArrow);
  this->setFocusPolicy(Qt::StrongFocus);
  column->addWidget(this);
  this->Body->setObjectName(name);
  this->Body->setVisible(false);
  this->Rows->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->Body);
  this->connect(this, &QToolButton::toggled, this,
    [this](bool on)
    {
      this->Body->setVisible(on);
      this->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    });
}
