// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMechanismGroup_h
#define pqHapticMechanismGroup_h

#include "pqHapticSettingRows.h"

#include <QGroupBox>
#include <QList>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class pqHapticStrip;
class pqPropertyLinks;
class vtkHapticSession;
class vtkSMProxy;

/// The group "Mechanism" of the panel: which source the hand holds a body of, a row a law with its present force, laws
/// to be added, removed and broken, and the force over the depth.
class pqHapticMechanismGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  explicit pqHapticMechanismGroup(QWidget* parent = nullptr);
  ~pqHapticMechanismGroup() override;

  void link(pqPropertyLinks& links, vtkSMProxy* proxy);
  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  void makeTable();
  void makeButtons();
  void addLaw();
  void removeLaw();
  void breakLaw();
  QString selected() const;
  void fill(vtkHapticSession& session);

  QPushButton *Use, *Leave, *Add, *Remove, *Break;
  QLineEdit* Law;
  QLabel* Text;
  QTableWidget* Table;
  pqHapticStrip* Chart;
  pqHapticSettingRows Rows;
};

#endif
