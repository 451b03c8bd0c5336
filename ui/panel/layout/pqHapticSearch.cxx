// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticSearch.h"

#include "pqHapticFields.h"

#include <QAbstractButton>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>

namespace
{
/// The words that find a widget: its text, its tip, its name and its property's.
QString WordsOf(const QWidget& widget)
{
  const auto* label = qobject_cast<const QLabel*>(&widget);
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  QString text = label ? label->text() : button ? button->text() : QString();
  return QStringList{ text.remove('&'), widget.toolTip(), widget.objectName(), pqHapticProperty(widget) }.join('\n');
}

/// The widgets of an item of a layout, from left to right.
void Add(QLayoutItem* item, QList<QWidget*>& row)
{
  if (item && item->widget())
  {
    row << item->widget();
  }
  for (int i = 0; item && item->layout() && i < item->layout()->count(); ++i)
  {
    Add(item->layout()->itemAt(i), row);
  }
}

/// A group without a form is one row.
QList<QList<QWidget*>> RowsOf(QWidget* group)
{
  const auto* form = qobject_cast<const QFormLayout*>(group->layout());
  QList<QList<QWidget*>> rows;
  for (int i = 0; form && i < form->rowCount(); ++i)
  {
    QList<QWidget*> row;
    for (const auto role : { QFormLayout::LabelRole, QFormLayout::FieldRole, QFormLayout::SpanningRole })
    {
      if (QLayoutItem* const item = form->itemAt(i, role))
      {
        Add(item, row);
      }
    }
    rows << row;
  }
  return form ? rows : QList<QList<QWidget*>>{ { group } };
}
} // namespace

pqHapticSearch::pqHapticSearch(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("search");
  this->setPlaceholderText(tr("Search settings"));
  this->setToolTip(tr("Show the rows of all pages that have these words in their title, their help text or the name of "
                      "their property; Escape clears"));
  this->setClearButtonEnabled(true);
}

pqHapticSearch::~pqHapticSearch() = default;

bool pqHapticSearch::finds(const QList<QWidget*>& row) const
{
  QString words;
  for (const QWidget* widget : row)
  {
    words += WordsOf(*widget) + '\n';
    for (const QWidget* inner : widget->findChildren<QWidget*>())
    {
      words += WordsOf(*inner) + '\n';
    }
  }
  for (const QString& word : this->text().simplified().split(' '))
  {
    if (!words.contains(word, Qt::CaseInsensitive))
    {
      return false;
    }
  }
  return true;
}

void pqHapticSearch::show(QWidget* widget, bool found)
{
  if (!found && !widget->isHidden())
  {
    this->Hidden.insert(widget);
    widget->hide();
  }
  else if (found && this->Hidden.remove(widget))
  {
    widget->show();
  }
}

int pqHapticSearch::applyTo(QWidget* group)
{
  int found = 0;
  auto* form = qobject_cast<QFormLayout*>(group->layout());
  if (form && !this->Spacings.contains(form))
  {
    this->Spacings[form] = form->verticalSpacing();
    form->setVerticalSpacing(0);
  }
  for (const QList<QWidget*>& row : RowsOf(group))
  {
    const bool here = this->finds(row);
    found += here ? 1 : 0;
    for (QWidget* widget : row)
    {
      this->show(widget, here);
    }
  }
  this->show(group, found > 0);
  return found;
}

int pqHapticSearch::apply(const QList<QWidget*>& pages)
{
  int all = 0;
  for (QWidget* page : pages)
  {
    int found = 0;
    for (int i = 0; i < page->layout()->count(); ++i)
    {
      if (QWidget* const group = page->layout()->itemAt(i)->widget())
      {
        found += this->applyTo(group);
      }
    }
    this->show(page, found > 0);
    all += found;
  }
  return all;
}

void pqHapticSearch::restore()
{
  for (QWidget* widget : this->Hidden)
  {
    widget->show();
  }
  this->Hidden.clear();
  for (auto form = this->Spacings.begin(); form != this->Spacings.end(); ++form)
  {
    form.key()->setVerticalSpacing(form.value());
  }
  this->Spacings.clear();
}

void pqHapticSearch::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Escape)
  {
    this->clear();
    return;
  }
  this->Superclass::keyPressEvent(event);
}
