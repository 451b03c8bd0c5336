// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticLayoutChecks.h"

#include <QScrollBar>
#include <QWidget>
#include <QtDebug>

#include <algorithm>

namespace
{
/// The names of Qt's own parts of a widget begin so.
bool IsOurs(const QWidget& widget)
{
  return !widget.objectName().isEmpty() && !widget.objectName().startsWith("qt_");
}

QString PathOf(const QWidget& widget, const QWidget& within)
{
  QString path = widget.objectName();
  for (const QWidget* at = widget.parentWidget(); at && at != &within; at = at->parentWidget())
  {
    path.prepend(at->objectName() + '/');
  }
  return path;
}

/// How much of a widget's width and of its height those around it show.
QSize SeenOf(const QWidget& widget, const QWidget& window)
{
  const QPoint corner = widget.mapTo(&window, QPoint());
  int left = corner.x(), right = left + widget.width(), top = corner.y(), bottom = top + widget.height();
  for (const QWidget* at = widget.parentWidget(); at; at = at == &window ? nullptr : at->parentWidget())
  {
    const QPoint other = at->mapTo(&window, QPoint());
    left = std::max(left, other.x());
    right = std::min(right, other.x() + at->width());
    top = std::max(top, other.y());
    bottom = std::min(bottom, other.y() + at->height());
  }
  return { right - left, bottom - top };
}
} // namespace

pqHapticPlaces pqHapticPlacesIn(QObject* object)
{
  const auto* within = qobject_cast<const QWidget*>(object);
  pqHapticPlaces places;
  for (const QWidget* widget : object->findChildren<QWidget*>())
  {
    if (within && widget->isVisible() && IsOurs(*widget) && widget->window() == within->window())
    {
      places[PathOf(*widget, *within)] = QRect(widget->mapTo(within->window(), QPoint()), widget->size());
    }
  }
  return places;
}

bool pqHapticIsStill(QObject* object, const pqHapticPlaces& before)
{
  const pqHapticPlaces now = pqHapticPlacesIn(object);
  int moved = 0;
  for (auto place = before.begin(); place != before.end(); ++place)
  {
    if (now.value(place.key()) != place.value())
    {
      ++moved;
      qCritical() << "hapticStill:" << place.key() << "was at" << place.value() << ", is at" << now.value(place.key());
    }
  }
  if (before.isEmpty())
  {
    qCritical() << "hapticStill: no place is remembered";
  }
  return moved == 0 && !before.isEmpty();
}

bool pqHapticIsSeen(QObject* object, bool whole)
{
  int seen = 0, cut = 0;
  for (const QWidget* widget : object->findChildren<QWidget*>())
  {
    if (!widget->isVisible() || !IsOurs(*widget) || qobject_cast<const QScrollBar*>(widget))
    {
      continue;
    }
    ++seen;
    const QSize shown = SeenOf(*widget, *widget->window());
    if (shown.width() < widget->width() || (whole && shown.height() < widget->height()))
    {
      ++cut;
      qCritical() << "hapticSeen: of" << widget->objectName() << widget->size() << "only" << shown << "is seen";
    }
  }
  if (seen == 0)
  {
    qCritical() << "hapticSeen: nothing is visible";
  }
  return cut == 0 && seen > 0;
}
