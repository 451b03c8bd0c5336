// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticGlossary.h"

#include <QAbstractButton>
#include <QFile>
#include <QGroupBox>
#include <QHelpEvent>
#include <QLabel>
#include <QRegularExpression>
#include <QToolTip>

#include <algorithm>

namespace
{
constexpr int cellsOfRow = 4; // term, definition, name in the code, source

/// Without text in brackets and without symbols: "soft (deformable) body" is "soft body".
QStringList NamesIn(QString title)
{
  static const QRegularExpression extra(R"(\s*\([^)]*\)|\s*`[^`]*`)");
  return title.remove(extra).split(", ");
}

QList<pqHapticTerm> ReadTerms()
{
  QList<pqHapticTerm> terms;
  QFile page(":/palpate/glossary.md");
  const QByteArray text = page.open(QIODevice::ReadOnly) ? page.readAll() : QByteArray();
  for (const QString& line : QString::fromUtf8(text).split('\n'))
  {
    const QStringList cells = line.mid(2).split(" | ");
    if (line.startsWith("| ") && cells.size() == cellsOfRow && cells[0] != "term")
    {
      terms.push_back({ QString(cells[0]).remove('`'), NamesIn(cells[0]), QString(cells[1]).remove('`') });
    }
  }
  return terms;
}

/// As a word of its own, or its plural.
bool Has(const QString& title, const QString& name)
{
  const QRegularExpression word(
    "\\b" + QRegularExpression::escape(name) + "s?\\b", QRegularExpression::CaseInsensitiveOption);
  return title.contains(word);
}

/// The label whose buddy the field is.
const QLabel* RowOf(const QWidget& field)
{
  const QList<QLabel*> labels = field.parentWidget()
                                  ? field.parentWidget()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly)
                                  : QList<QLabel*>();
  const auto leads = [&field](const QLabel* label) { return label->buddy() == &field; };
  const auto found = std::find_if(labels.begin(), labels.end(), leads);
  return found == labels.end() ? nullptr : *found;
}

QString OwnTipOf(const QWidget& widget)
{
  const auto* const label = qobject_cast<const QLabel*>(&widget);
  return widget.toolTip().isEmpty() && label && label->buddy() ? label->buddy()->toolTip() : widget.toolTip();
}
} // namespace

const QList<pqHapticTerm>& pqHapticTerms()
{
  static const QList<pqHapticTerm> terms = ReadTerms();
  return terms;
}

pqHapticGlossary::pqHapticGlossary(QWidget* panel) : Superclass(panel)
{
  for (QWidget* const widget : panel->findChildren<QWidget*>())
  {
    widget->installEventFilter(this);
  }
}

pqHapticGlossary::~pqHapticGlossary() = default;

QString pqHapticGlossary::titleOf(const QWidget& widget)
{
  const QLabel* const row = RowOf(widget);
  const auto* const label = row ? row : qobject_cast<const QLabel*>(&widget);
  const auto* const button = qobject_cast<const QAbstractButton*>(&widget);
  const auto* const group = qobject_cast<const QGroupBox*>(&widget);
  return (label ? label->text() : button ? button->text() : group ? group->title() : QString()).remove('&');
}

QString pqHapticGlossary::tipOf(const QWidget& widget)
{
  const QString tip = OwnTipOf(widget), title = titleOf(widget);
  QString definitions;
  for (const pqHapticTerm& term : pqHapticTerms())
  {
    const auto named = [&title](const QString& name) { return Has(title, name); };
    if (std::any_of(term.Names.begin(), term.Names.end(), named))
    {
      definitions += QString("<p><b>%1</b>: %2</p>").arg(term.Title.toHtmlEscaped(), term.Definition.toHtmlEscaped());
    }
  }
  return definitions.isEmpty() ? tip : QString("<p>%1</p>%2").arg(tip.toHtmlEscaped(), definitions);
}

bool pqHapticGlossary::eventFilter(QObject* object, QEvent* event)
{
  auto* const widget = qobject_cast<QWidget*>(object);
  const QString tip = widget && event->type() == QEvent::ToolTip ? tipOf(*widget) : QString();
  if (tip.isEmpty())
  {
    return false;
  }
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), tip, widget);
  return true;
}
