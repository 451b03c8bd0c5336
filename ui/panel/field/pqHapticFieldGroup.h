// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticFieldGroup_h
#define pqHapticFieldGroup_h

#include "pqHapticViewFollower.h"
#include "pqPropertyLinks.h"
#include "vtkSMProxy.h"
#include "vtkWeakPointer.h"

#include <QGroupBox>
#include <QList>
#include <QPointer>

class QFormLayout;
class QLabel;
class pqHapticArrayChoice;
class pqHapticSettingRows;
class vtkHapticSession;

/**
 * Which arrays of what is shown are felt as a field, how, and what is felt at the hand.
 */
class pqHapticFieldGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  /// `rows` adds those of the settings that name this group.
  explicit pqHapticFieldGroup(pqHapticSettingRows& rows, QWidget* parent = nullptr);

  void setProxy(vtkSMProxy* proxy);
  /// Null: there is no session.
  void refresh(vtkHapticSession* session, const pqHapticViewFollower& follower);
  /// The lists of arrays, from top to bottom.
  QList<QWidget*> fields() const;

private:
  struct Choice
  {
    const char* Property;
    int Components; ///< that an array must have; 0: any
    pqHapticArrayChoice* List;
  };
  void add(QFormLayout* form, const char* property, int components);
  /// What the colour maps of the view say of what is felt, to the settings.
  void takeColours();

  QList<Choice> Choices;
  QLabel* Sentence;
  QLabel* Value;
  QLabel* Around;
  QLabel* Taken;
  pqPropertyLinks Links;
  vtkWeakPointer<vtkSMProxy> Proxy;
  QPointer<const pqHapticViewFollower> Follower; ///< of the view that is looked at
};

#endif
