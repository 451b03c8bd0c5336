// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticFieldGroup_h
#define pqHapticFieldGroup_h

#include "pqPropertyLinks.h"

#include <QGroupBox>
#include <QList>

class QFormLayout;
class QLabel;
class pqHapticArrayChoice;
class pqHapticSettingRows;
class pqHapticViewFollower;
class vtkHapticSession;
class vtkSMProxy;

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

  QList<Choice> Choices;
  QLabel* Sentence;
  QLabel* Value;
  pqPropertyLinks Links;
};

#endif
