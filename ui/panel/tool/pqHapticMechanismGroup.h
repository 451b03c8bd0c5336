// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMechanismGroup_h
#define pqHapticMechanismGroup_h

#include "pqHapticGroup.h"

class QLineEdit;
class QTableWidget;
class pqHapticStrip;

/// The group "Mechanism" of the panel: which source the hand holds a body of, a row a constraint with its present
/// force, constraints to be added, removed and broken, and the force over the depth. A wire has neither constraints nor
/// bodies to put back: it is regripped and pulled out.
class pqHapticMechanismGroup : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  explicit pqHapticMechanismGroup(QWidget* parent = nullptr);

  void link(pqPropertyLinks& links, vtkSMProxy* proxy) override;
  void refresh(vtkHapticSession* session) override;
  QList<QWidget*> fields() const override;

private:
  void makeTable();
  void makeButtons();
  void addConstraint();
  void removeConstraint();
  void breakConstraint();
  void putBack();
  QString selected() const;
  void fill(vtkHapticSession& session);
  void showRows(bool held, bool wire);

  QPushButton *Add, *Remove, *Break, *PutBack, *Regrip;
  QLineEdit* Constraint;
  QLabel* Text;
  QTableWidget* Table;
  pqHapticStrip* Chart;
};

#endif
