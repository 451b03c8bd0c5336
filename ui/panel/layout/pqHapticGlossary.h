// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticGlossary_h
#define pqHapticGlossary_h

#include <QList>
#include <QObject>
#include <QString>
#include <QStringList>

class QWidget;

/// A term of docs/glossary.md, which is a resource of the plugin.
struct pqHapticTerm
{
  QString Title;     ///< as the page has it: "proxy, god-object"
  QStringList Names; ///< each of its names: "proxy" and "god-object"
  QString Definition;
};

[[nodiscard]] const QList<pqHapticTerm>& pqHapticTerms();

/**
 * The tips of the widgets of the panel have the definition of each term of the glossary that their title has.
 *
 * The title of a field is the text of its row. The title of a row has the tip of its field. The definitions are added
 * when a tip is shown: no tip holds them, so that a search over the tips finds nothing by their words.
 */
class pqHapticGlossary : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  /// For all widgets that the panel has now.
  explicit pqHapticGlossary(QWidget* panel);
  ~pqHapticGlossary() override;

  /// The text of a label, a button or a group, or of the row of a field; without a mnemonic.
  [[nodiscard]] static QString titleOf(const QWidget& widget);
  /// The tip as it is shown: as HTML where there are definitions.
  [[nodiscard]] static QString tipOf(const QWidget& widget);

  bool eventFilter(QObject* object, QEvent* event) override;
};

#endif
