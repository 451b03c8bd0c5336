// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticFieldGroup_h
#define pqHapticFieldGroup_h

#include "pqHapticGroup.h"

#include "vtkSMProxy.h"
#include "vtkWeakPointer.h"

class pqHapticArrayChoice;

/**
 * Which arrays of the shown data are felt as a field, how, and the field at the hand.
 */
class pqHapticFieldGroup : public pqHapticGroup
{
  Q_OBJECT
  typedef pqHapticGroup Superclass;

public:
  explicit pqHapticFieldGroup(QWidget* parent = nullptr);

  void link(pqPropertyLinks& links, vtkSMProxy* proxy) override;
  void refresh(vtkHapticSession* session) override;
  QList<QWidget*> fields() const override;

private:
  struct Choice
  {
    const char* Property;
    int Components; ///< that an array must have; 0: any
    pqHapticArrayChoice* List;
  };
  void add(const char* property, int components);
  /// Takes the ranges of the view's colour maps to the settings.
  void takeColours();

  QList<Choice> Choices;
  QLabel* Sentence;
  QLabel* Value;
  QLabel* Around;
  QLabel* Taken;
  vtkWeakPointer<vtkSMProxy> Proxy;
};

#endif
