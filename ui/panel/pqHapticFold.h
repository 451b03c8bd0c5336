// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticFold_h
#define pqHapticFold_h

#include <QToolButton>

class QVBoxLayout;

/// A button of the panel that unfolds what stands below it, folded at first.
class pqHapticFold : public QToolButton
{
  Q_OBJECT
  typedef QToolButton Superclass;

public:
  /// Both are added to `column`. What is folded is named `name`, the button nameButton.
  pqHapticFold(QVBoxLayout* column, const QString& name, const QString& title, const QString& tip);

  /// What is folded, and where its rows go.
  QWidget* body() const { return this->Body; }
  QVBoxLayout* rows() const { return this->Rows; }

private:
  QWidget* Body;
  QVBoxLayout* Rows;
};

#endif
