// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticFold_h
#define pqHapticFold_h

#include <QToolButton>

class QVBoxLayout;

/// A button of the panel that unfolds its content below, folded at first.
class pqHapticFold : public QToolButton
{
  Q_OBJECT
  typedef QToolButton Superclass;

public:
  /// Both are added to `column`. The folded widget is named `name`, the button nameButton.
  pqHapticFold(QVBoxLayout* column, const QString& name, const QString& title, const QString& tip);

  /// The folded widget, and the layout of its rows.
  QWidget* body() const { return this->Body; }
  QVBoxLayout* rows() const { return this->Rows; }

private:
  QWidget* Body;
  QVBoxLayout* Rows;
};

#endif
