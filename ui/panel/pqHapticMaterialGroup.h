// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMaterialGroup_h
#define pqHapticMaterialGroup_h

#include "pqPropertyLinks.h" // for a member

#include <QGroupBox>
#include <QList>
#include <QStringList>

#include <vector>

class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;
class pqHapticArrayChoice;
class vtkSMProxy;

/// The group "Material" of the panel: which arrays of what is shown make its stiffness, friction and texture, and how.
class pqHapticMaterialGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  explicit pqHapticMaterialGroup(QWidget* parent = nullptr);

  /// The session whose settings these are; null: none.
  void setProxy(vtkSMProxy* proxy);
  void setArrayNames(const QStringList& names);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  /// What one array makes: the fields of its transfer, linked to the properties that begin with Property.
  struct Transfer
  {
    const char* Property;
    pqHapticArrayChoice* Array;
    QSpinBox* Component;
    QDoubleSpinBox* Data[2];
    QDoubleSpinBox* Felt[2];
  };
  struct Looks
  {
    const char* Property; ///< "Stiffness"
    const char* Name;     ///< of the widgets: "stiffness"
    int Decimals;         ///< of what it feels like
  };

  void add(QFormLayout* form, const Looks& looks);
  void addDetails(QWidget* parent, const Looks& looks, Transfer& transfer);
  void link(const Transfer& transfer, vtkSMProxy* proxy);

  std::vector<Transfer> Transfers;
  pqPropertyLinks Links;
};

#endif
