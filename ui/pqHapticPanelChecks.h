// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticPanelChecks_h
#define pqHapticPanelChecks_h

class QObject;
#include <QStringList>

// Checks of the widgets in an object for event scripts. Each reports a failure with qCritical().

/// Tab goes through these fields in this order.
bool pqHapticHasTabOrder(QObject* object, const QStringList& names);

/// A letter stands in a word and for one thing; a title without one is reached by Tab.
bool pqHapticHasMnemonics(QObject* object);

/// The text of every label, button and strip that is seen fits into it, has at least that contrast in a picture of it,
/// 1 to 21 as WCAG 2 defines it for the lightest and the darkest pixel, and the picture so many pixels a point.
bool pqHapticHasReadableText(QObject* object, double contrast, double ratio);

/// Whatever a label that is enabled, a page of text, a table, or the status bar of a window says.
QString pqHapticSaidBy(const QObject* object);

/// These words are among that.
bool pqHapticHas(const QObject* object, const QString& words);

/// The next step back of ParaView's undo has this name.
bool pqHapticIsUndoStep(const QString& name);

/// Of the terms of the glossary, these and no others stand in titles of the object, and the tips of these titles have
/// their definitions.
bool pqHapticExplains(QObject* object, QStringList names);

/// The tip that a pointer which rests on the widget brings up has these words.
bool pqHapticHasTip(QObject* object, const QString& words);

/// Light text on dark ground in all windows from now on.
bool pqHapticGoDark();

#endif
