// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticArrayChoice_h
#define pqHapticArrayChoice_h

#include <QComboBox>
#include <QStringList>

/**
 * A list of arrays of which one or none is chosen. The chosen one stays chosen, and in the list, when no surface that
 * is shown has it: a state file may come before its data.
 */
class pqHapticArrayChoice : public QComboBox
{
  Q_OBJECT
  typedef QComboBox Superclass;

  /// Name of the chosen array; empty: none.
  Q_PROPERTY(QString array READ array WRITE setArray NOTIFY arrayChanged)

public:
  explicit pqHapticArrayChoice(QWidget* parent = nullptr);

  QString array() const;
  void setArray(const QString& name);
  /// The choices, besides none.
  void setNames(const QStringList& names);

Q_SIGNALS:
  void arrayChanged();
};

#endif
