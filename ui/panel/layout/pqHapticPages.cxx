// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticPages.h"

#include "pqHapticLabel.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QPixmap>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int rowSpacing = 3; // the page that is seen first fits on a screen of 768 lines [pixels]

/// Text that is still read with a contrast of at least 4.5, on light ground and on dark.
QColor Grey(const QPalette& palette)
{
  constexpr double ofText = 0.62;
  const QColor text = palette.color(QPalette::Active, QPalette::ButtonText), ground = palette.color(QPalette::Window);
  const auto mixed = [](int one, int other) { return static_cast<int>(ofText * one + (1.0 - ofText) * other); };
  return { mixed(text.red(), ground.red()), mixed(text.green(), ground.green()), mixed(text.blue(), ground.blue()) };
}

QScrollArea* Scrolled(QWidget* parent, const char* name, QWidget* content)
{
  auto* scroll = new QScrollArea(parent);
  scroll->setObjectName(name);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  scroll->setFocusPolicy(Qt::NoFocus); // its fields have the focus
  return scroll;
}

int WidthOf(const QScrollArea& scroll, int content)
{
  return content + scroll.verticalScrollBar()->sizeHint().width() + 2 * scroll.frameWidth();
}
} // namespace

pqHapticPages::pqHapticPages(QWidget* parent) : Superclass(parent)
{
  this->setObjectName("pages");
  auto* list = new QWidget;
  list->setObjectName("list");
  this->Buttons = new QVBoxLayout(list);
  this->Buttons->setContentsMargins(0, 0, 0, 0);
  this->Buttons->setSpacing(0);
  this->Buttons->addStretch(1);
  auto* body = new QWidget;
  body->setObjectName("body");
  this->Column = new QVBoxLayout(body);
  this->Column->setSpacing(rowSpacing);
  this->Column->setContentsMargins(0, 0, rowSpacing, 0);
  this->Note = pqHapticLabel(body, "searchNote", tr("Result of the search"));
  this->Column->addWidget(this->Note);
  this->Column->addStretch(1);
  this->Choice = Scrolled(this, "choice", list);
  this->Scroll = Scrolled(this, "scroll", body);
  this->Scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // rows keep their width where a text above folds
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Choice);
  row->addWidget(this->Scroll, 1);
  this->Scroll->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding); // no wider than its pages need
  this->setNote(QString());
}

pqHapticPages::~pqHapticPages() = default;

QVBoxLayout* pqHapticPages::add(const QString& name, const QString& title, const QString& tip)
{
  auto* button = new QToolButton(this->Choice->widget());
  button->setObjectName(name + "Button");
  button->setText(title);
  button->setToolTip(tip);
  button->setCheckable(true);
  button->setAutoExclusive(true); // the arrow keys go through the list, and Tab to the page that is shown
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QPixmap nothing(1, 1);
  nothing.fill(Qt::transparent);
  button->setIcon(nothing); // Qt puts a text to the left only beside an icon
  button->setIconSize({ 1, 1 });
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  this->Buttons->insertWidget(static_cast<int>(this->All.size()), button);
  auto* page = new QWidget(this->Scroll->widget());
  page->setObjectName(name + "Page");
  page->setVisible(this->All.empty());
  this->Column->insertWidget(static_cast<int>(this->All.size()), page);
  auto* rows = new QVBoxLayout(page);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(rowSpacing);
  button->setChecked(this->All.empty());
  this->Chosen = this->All.empty() ? page : this->Chosen;
  this->All.push_back({ name, tip, button, page });
  this->connect(button, &QToolButton::clicked, this, [this, page] { this->choose(page); });
  return rows;
}

void pqHapticPages::choose(QWidget* page)
{
  this->Chosen = page;
  const auto shows = [page](const Page& other) { return other.Body == page; };
  this->Choice->ensureWidgetVisible(std::find_if(this->All.begin(), this->All.end(), shows)->Button);
  this->showAll(false);
  this->Scroll->verticalScrollBar()->setValue(0);
  Q_EMIT this->chosen();
}

void pqHapticPages::setReasons(const QMap<QString, QString>& reasons)
{
  for (auto reason = reasons.begin(); reason != reasons.end(); ++reason)
  {
    this->setReason(reason.key(), reason.value());
  }
}

void pqHapticPages::setReason(const QString& name, const QString& reason)
{
  const auto named = [&name](const Page& page) { return page.Name == name; };
  const auto page = std::find_if(this->All.begin(), this->All.end(), named);
  if (page == this->All.end())
  {
    return;
  }
  QPalette colours = this->palette();
  if (!reason.isEmpty())
  {
    colours.setColor(QPalette::ButtonText, Grey(colours));
  }
  if (page->Button->palette().color(QPalette::ButtonText) != colours.color(QPalette::ButtonText))
  {
    page->Button->setPalette(colours);
  }
  if (const QString tip = reason.isEmpty() ? page->Tip : reason; tip != page->Button->toolTip())
  {
    page->Button->setToolTip(tip);
    page->Button->setAccessibleDescription(tip);
  }
}

QList<QWidget*> pqHapticPages::pages() const
{
  QList<QWidget*> bodies;
  for (const Page& page : this->All)
  {
    bodies << page.Body;
  }
  return bodies;
}

QString pqHapticPages::chosenName() const
{
  const auto chosen = [this](const Page& page) { return page.Body == this->Chosen; };
  const auto page = std::find_if(this->All.begin(), this->All.end(), chosen);
  return page == this->All.end() ? QString() : page->Name;
}

void pqHapticPages::showAll(bool all)
{
  for (const Page& page : this->All)
  {
    page.Body->setVisible(all || page.Body == this->Chosen);
  }
}

void pqHapticPages::setNote(const QString& text)
{
  pqHapticSay(this->Note, text);
}

void pqHapticPages::fitWidth()
{
  int widest = 0;
  for (const Page& page : this->All)
  {
    widest = std::max(widest, page.Body->minimumSizeHint().width());
  }
  const int width = WidthOf(*this->Scroll, widest + rowSpacing);
  if (width > this->Scroll->minimumWidth()) // a text that became shorter moves nothing
  {
    this->Scroll->setMinimumWidth(width);
  }
  // With space for its scroll bar, which comes and goes with the height that texts leave to the list.
  const int choice = WidthOf(*this->Choice, this->Choice->widget()->sizeHint().width());
  if (choice != this->Choice->minimumWidth())
  {
    this->Choice->setFixedWidth(choice);
  }
}

QList<QWidget*> pqHapticPages::fields() const
{
  QList<QWidget*> buttons;
  for (const Page& page : this->All)
  {
    buttons << page.Button;
  }
  return buttons;
}
