// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMainGroup_h
#define pqHapticMainGroup_h

#include "pqHapticSettingRows.h"

#include <QList>
#include <QStringList>
#include <QWidget>

class pqHapticArrayChoice;
class pqHapticRecordingRows;
class pqPropertyLinks;
class vtkHapticSession;
class vtkSMProxy;

/// The page that is seen first: the settings that a person needs first, and recordings.
class pqHapticMainGroup : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticMainGroup(QWidget* parent = nullptr);
  ~pqHapticMainGroup() override;

  /// Null: nothing can be set.
  void setProxy(vtkSMProxy* proxy, pqPropertyLinks& links);
  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);
  /// Of the touchable data now.
  void setArrayNames(const QStringList& names);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  pqHapticSettingRows Rows;
  pqHapticArrayChoice* Stiffness; ///< also on the page of materials, which has its ranges
  pqHapticRecordingRows* Recording;
};

#endif
