// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticSourceGroup_h
#define pqHapticSourceGroup_h

#include "pqHapticGroup.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

/// How the source that is active in the pipeline browser is touched: at all, as fixed, loose or soft, and with its own
/// material, where that is not the session's.
class pqHapticSourceGroup : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  explicit pqHapticSourceGroup(QWidget* parent = nullptr);

  void refresh(vtkHapticSession* session) override;
  QList<QWidget*> fields() const override;

private:
  QDoubleSpinBox* addNumber(const char* name, const QString& title, const QString& tip);
  void setTouched(bool on);
  void setKind(int kind);
  void setDensity(double density);
  void setStatic(double friction);
  void setKinetic(double friction);
  void setMaterial();

  QLabel* Source;
  QCheckBox* Touched;
  QComboBox* Kind;
  QDoubleSpinBox* Density;
  QLabel* Loose;
  QDoubleSpinBox* Stiffness;
  QDoubleSpinBox* FrictionStatic;
  QDoubleSpinBox* FrictionKinetic;
};

#endif
