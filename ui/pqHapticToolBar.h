// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticToolBar_h
#define pqHapticToolBar_h

#include <QToolBar>

/// The toolbar "Haptics": touch and let go.
class pqHapticToolBar : public QToolBar
{
  Q_OBJECT
  typedef QToolBar Superclass;

public:
  explicit pqHapticToolBar(const QString& title, QWidget* parent = nullptr);
  explicit pqHapticToolBar(QWidget* parent = nullptr);

private:
  void build();
};

#endif
