// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSearch_h
#define pqHapticSearch_h

#include <QLineEdit>
#include <QList>
#include <QMap>
#include <QSet>

class QFormLayout;

/**
 * Finds rows of the panel by words of their title, sentence, or property: hides all others while there is a text.
 *
 * A row is found if each of the words is in it, in any case of letters. Escape clears the text.
 */
class pqHapticSearch : public QLineEdit
{
  Q_OBJECT
  typedef QLineEdit Superclass;

public:
  explicit pqHapticSearch(QWidget* parent = nullptr);
  ~pqHapticSearch() override;

  bool active() const { return !this->text().trimmed().isEmpty(); }
  /// Shows the rows of these pages that are found, and hides the others, which others may have shown since. Returns how
  /// many are found.
  int apply(const QList<QWidget*>& pages);
  /// Shows the hidden rows.
  void restore();

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  bool finds(const QList<QWidget*>& row) const;
  int applyTo(QWidget* group);
  void show(QWidget* widget, bool found);

  QSet<QWidget*> Hidden;
  QMap<QFormLayout*, int> Spacings; ///< of forms with hidden rows, which take their spacing else [pixels]
};

#endif
