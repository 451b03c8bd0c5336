// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticArrayChoice.h"

#include <QSignalBlocker>

pqHapticArrayChoice::pqHapticArrayChoice(QWidget* parent) : Superclass(parent)
{
  this->addItem(tr("no array"));
  this->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // a long name makes no wide panel
  this->connect(
    this, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int) { Q_EMIT this->arrayChanged(); });
}

QString pqHapticArrayChoice::array() const
{
  return this->currentIndex() > 0 ? this->currentText() : QString(""); // a null string is never sent to a property
}

void pqHapticArrayChoice::setArray(const QString& name)
{
  constexpr int first = 1; // after "no array"
  int index = 0;
  for (int i = first; i < this->count() && !name.isEmpty(); ++i)
  {
    index = this->itemText(i) == name ? i : index;
  }
  if (index == 0 && !name.isEmpty())
  {
    this->addItem(name);
    index = this->count() - 1;
  }
  this->setCurrentIndex(index);
}

void pqHapticArrayChoice::setNames(const QStringList& names)
{
  QStringList wanted = names;
  const QString chosen = this->array();
  if (!chosen.isEmpty() && !wanted.contains(chosen))
  {
    wanted.append(chosen);
  }
  QStringList listed;
  for (int i = 1; i < this->count(); ++i)
  {
    listed.append(this->itemText(i));
  }
  if (listed == wanted)
  {
    return;
  }
  const QSignalBlocker nothingWasChosen(this);
  while (this->count() > 1)
  {
    this->removeItem(1);
  }
  this->addItems(wanted);
  this->setArray(chosen);
}
