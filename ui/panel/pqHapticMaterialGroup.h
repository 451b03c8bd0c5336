// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMaterialGroup_h
#define pqHapticMaterialGroup_h

#include "pqHapticGroup.h"

#include <QStringList>
#include <vector>

class QDoubleSpinBox;
class QSpinBox;
class pqHapticArrayChoice;
class pqHapticQuantityBox;

/// The group "Material" of the panel: which arrays of the visible data set its stiffness, friction and texture, and
/// how.
class pqHapticMaterialGroup : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  explicit pqHapticMaterialGroup(QWidget* parent = nullptr);

  void setArrayNames(const QStringList& names);
  void link(pqPropertyLinks& links, vtkSMProxy* proxy) override;
  void refresh(vtkHapticSession* session) override;
  QList<QWidget*> fields() const override;

private:
  /// The use of one array: the fields of its transfer, linked to the properties that begin with Property.
  struct Transfer
  {
    const char* Property;
    pqHapticArrayChoice* Array;
    QWidget* Details; ///< visible while an array is chosen
    QSpinBox* Component;
    pqHapticQuantityBox* Data[2];
    QDoubleSpinBox* Felt[2];
  };
  struct Looks
  {
    const char* Property; ///< "Stiffness"
    const char* Name;     ///< of the widgets: "stiffness"
    int Decimals;         ///< of the target range
  };

  void add(const Looks& looks);
  /// Of a transfer without an array there are no details.
  void followChoices();
  void addDetails(QWidget* parent, const Looks& looks, Transfer& transfer);

  std::vector<Transfer> Transfers;
  QLabel* Cut; ///< that the spring cuts stiffness
};

#endif
