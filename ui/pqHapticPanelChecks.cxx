// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticPanelChecks.h"

#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqHapticGlossary.h"
#include "pqUndoStack.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QHelpEvent>
#include <QImage>
#include <QKeySequence>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QPalette>
#include <QPixmap>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QSet>
#include <QStatusBar>
#include <QStringList>
#include <QTableWidget>
#include <QToolTip>
#include <QWidget>
#include <QtDebug>

#include <algorithm>
#include <cmath>

namespace
{
/// WCAG 2: of a channel of sRGB, 0 to 1.
double Linear(double channel)
{
  return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double Luminance(QRgb pixel)
{
  return 0.2126 * Linear(qRed(pixel) / 255.0) + 0.7152 * Linear(qGreen(pixel) / 255.0) +
         0.0722 * Linear(qBlue(pixel) / 255.0);
}

double ContrastIn(const QImage& picture)
{
  double least = 1.0, most = 0.0;
  for (int y = 0; y < picture.height(); ++y)
  {
    for (int x = 0; x < picture.width(); ++x)
    {
      const double luminance = Luminance(picture.pixel(x, y));
      least = std::min(least, luminance);
      most = std::max(most, luminance);
    }
  }
  return (most + 0.05) / (least + 0.05);
}

/// Of a widget that has no other; "" where it wraps or shows none.
QString PlainText(const QWidget& widget)
{
  const auto* label = qobject_cast<const QLabel*>(&widget);
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const bool wraps = label && (label->wordWrap() || label->inherits("pqHapticLines"));
  return label && !wraps ? label->text() : button ? button->text() : QString();
}

bool Shows(const QWidget& widget)
{
  const auto* label = qobject_cast<const QLabel*>(&widget);
  return !PlainText(widget).isEmpty() || (label && !label->text().isEmpty()) || widget.inherits("pqHapticStrip");
}

/// Of the menus in its bar, and of the buttons of its Properties panel, which a person presses after every change.
QSet<QString> MnemonicsOfParaView()
{
  const auto* window = qobject_cast<const QMainWindow*>(pqCoreUtilities::mainWidget());
  QSet<QString> keys;
  for (const QAction* menu : window->menuBar()->actions())
  {
    keys << QKeySequence::mnemonic(menu->text()).toString();
  }
  for (const QAbstractButton* button : window->findChild<QWidget*>("propertiesDock")->findChildren<QAbstractButton*>())
  {
    keys << QKeySequence::mnemonic(button->text()).toString();
  }
  return keys - QSet<QString>{ QString() };
}

bool Fits(const QWidget& widget)
{
  QString text = PlainText(widget);
  return widget.fontMetrics().horizontalAdvance(text.remove('&')) <= widget.width() &&
         widget.fontMetrics().height() <= widget.height();
}
} // namespace

namespace
{
/// Cells of a row apart by commas.
QString TextOf(const QTableWidget& table)
{
  QStringList rows;
  for (int row = 0; row < table.rowCount(); ++row)
  {
    QStringList cells;
    for (int column = 0; column < table.columnCount(); ++column)
    {
      cells << table.item(row, column)->text();
    }
    rows << cells.join(", ");
  }
  return rows.join("\n");
}
} // namespace

QString pqHapticSaidBy(const QObject* object)
{
  const auto* label = qobject_cast<const QLabel*>(object);
  const auto* table = qobject_cast<const QTableWidget*>(object);
  const auto* page = qobject_cast<const QPlainTextEdit*>(object);
  const auto* window = qobject_cast<const QMainWindow*>(object);
  return label && label->isEnabled() ? label->text()
         : page                      ? page->toPlainText()
         : table                     ? TextOf(*table)
         : window                    ? window->statusBar()->currentMessage()
                                     : QString();
}

bool pqHapticHas(const QObject* object, const QString& words)
{
  const QString said = pqHapticSaidBy(object);
  if (!said.contains(words))
  {
    qCritical() << "hapticHas" << words << ": it says" << said;
  }
  return said.contains(words);
}

bool pqHapticHasTabOrder(QObject* object, const QStringList& names)
{
  const auto* body = qobject_cast<const QWidget*>(object); // outside, ParaView has widgets of the same names
  const auto* first = body ? body->findChild<QWidget*>(names.value(0)) : nullptr;
  QStringList reached;
  for (const QWidget* at = first; at && (reached.isEmpty() || at != first); at = at->nextInFocusChain())
  {
    if (body->isAncestorOf(at) && names.contains(at->objectName()) && (at->focusPolicy() & Qt::TabFocus))
    {
      reached << at->objectName();
    }
  }
  if (reached != names)
  {
    qCritical() << "hapticTabOrder" << names << ": Tab goes to" << reached;
  }
  return reached == names;
}

bool pqHapticHasMnemonics(QObject* object)
{
  QStringList keys, footnotes;
  for (const QWidget* widget : object->findChildren<QWidget*>())
  {
    const auto* label = qobject_cast<const QLabel*>(widget);
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const bool leads = label && label->buddy() && (label->buddy()->focusPolicy() & Qt::TabFocus);
    const QString title = leads ? label->text() : button ? button->text() : QString();
    const QString key = QKeySequence::mnemonic(title).toString();
    keys << (key.isEmpty() ? QStringList() : QStringList(key));
    footnotes << (title.contains("(&") ? QStringList(title) : QStringList());
  }
  const int twice = keys.removeDuplicates();
  const QStringList clash = QSet<QString>(keys.begin(), keys.end()).intersect(MnemonicsOfParaView()).values();
  if (twice > 0 || !footnotes.isEmpty() || !clash.isEmpty() || keys.isEmpty())
  {
    qCritical() << "hapticMnemonics:" << twice << "stand twice, these read as footnotes:" << footnotes
                << ", these are ParaView's:" << clash;
    return false;
  }
  return true;
}

bool pqHapticHasReadableText(QObject* object, double contrast, double ratio)
{
  QStringList wrong;
  int seen = 0;
  for (QWidget* widget : object->findChildren<QWidget*>())
  {
    if (!widget->isVisible() || !widget->isEnabled() || !Shows(*widget))
    {
      continue;
    }
    const QImage picture = widget->grab().toImage();
    const double has = ContrastIn(picture);
    ++seen;
    if (!Fits(*widget) || has < contrast || picture.devicePixelRatioF() != ratio)
    {
      wrong << QString("%1 \"%2\": contrast %3, %4 pixels a point, %5 x %6%7")
                 .arg(widget->objectName(), PlainText(*widget))
                 .arg(has)
                 .arg(picture.devicePixelRatioF())
                 .arg(widget->width())
                 .arg(widget->height())
                 .arg(Fits(*widget) ? "" : ", too small");
    }
  }
  if (!wrong.isEmpty() || seen == 0)
  {
    qCritical() << "hapticText: of" << seen << "these cannot be read:" << wrong;
  }
  return wrong.isEmpty() && seen > 0;
}

bool pqHapticGoDark()
{
  const QColor ground(45, 45, 45), deeper(30, 30, 30), text(230, 230, 230);
  QPalette dark(text, ground, ground.lighter(), deeper, ground, text, text, deeper, ground);
  dark.setColor(QPalette::Highlight, QColor(60, 120, 200));
  dark.setColor(QPalette::HighlightedText, text);
  QApplication::setPalette(dark);
  return true;
}

bool pqHapticIsUndoStep(const QString& name)
{
  pqUndoStack* const stack = pqApplicationCore::instance()->getUndoStack();
  const QString has = stack && stack->canUndo() ? stack->undoLabel() : QString();
  if (has != name)
  {
    qCritical() << "hapticUndoStep" << name << ": the next step back is" << has;
  }
  return has == name;
}

bool pqHapticExplains(QObject* object, QStringList names)
{
  QStringList met, silent;
  for (const QWidget* widget : object->findChildren<QWidget*>())
  {
    const QStringList words = pqHapticGlossary::titleOf(*widget).toLower().split(QRegularExpression("[^a-z-]+"));
    const QString tip = pqHapticGlossary::tipOf(*widget);
    for (const pqHapticTerm& term : pqHapticTerms())
    {
      for (const QString& name : term.Names)
      {
        const bool stands = ((" " + words.join(' ') + " ").contains(" " + name.toLower() + " "));
        met << (stands ? QStringList(name) : QStringList());
        const bool said = tip.contains(term.Definition.toHtmlEscaped());
        silent << (stands && !said ? QStringList(widget->objectName() + ": " + name) : QStringList());
      }
    }
  }
  met.removeDuplicates();
  met.sort();
  names.sort();
  if (met != names || !silent.isEmpty())
  {
    qCritical() << "hapticExplains" << names << ": titles have" << met << ", without a definition" << silent;
  }
  return met == names && silent.isEmpty();
}

bool pqHapticHasTip(QObject* object, const QString& words)
{
  auto* const widget = qobject_cast<QWidget*>(object);
  if (!widget)
  {
    return false;
  }
  const QPoint middle = widget->rect().center();
  QHelpEvent rests(QEvent::ToolTip, middle, widget->mapToGlobal(middle));
  QCoreApplication::sendEvent(widget, &rests);
  const bool has = QToolTip::text().contains(words);
  if (!has)
  {
    qCritical() << "hapticTip" << words << ": it is" << QToolTip::text();
  }
  QToolTip::hideText();
  return has;
}
