// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSourceGroup_h
#define pqHapticSourceGroup_h

#include <QGroupBox>
#include <QList>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class vtkHapticSession;

/// How the source that is active in the pipeline browser is touched: at all, and as what, where it is not as the
/// session's settings have it.
class pqHapticSourceGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  explicit pqHapticSourceGroup(QWidget* parent = nullptr);

  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  QDoubleSpinBox* addNumber(QFormLayout* form, const char* name, const QString& title, const QString& tip);
  void setTouched(bool on);
  void setStatic(double friction);
  void setKinetic(double friction);
  void setMaterial();

  QLabel* Name;
  QCheckBox* Touched;
  QDoubleSpinBox* Stiffness;
  QDoubleSpinBox* FrictionStatic;
  QDoubleSpinBox* FrictionKinetic;
};

#endif
