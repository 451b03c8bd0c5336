// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMouseHelp_h
#define pqHapticMouseHelp_h

#include <QWidget>

class QLabel;
class pqHapticFold;
class vtkHapticSession;

/// How mouse and keys move the hand in the view, until the mouse has pressed for the first time; afterwards its fold
/// brings it back.
class pqHapticMouseHelp : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticMouseHelp(QWidget* parent = nullptr);
  ~pqHapticMouseHelp() override;

  /// The button that folds it.
  pqHapticFold* fold() const { return this->Fold; }
  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);

private:
  pqHapticFold* Fold;
  QLabel* Text;
  bool Learnt = false; ///< the mouse has pressed
};

#endif
