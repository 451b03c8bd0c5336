// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMainGroup_h
#define pqHapticMainGroup_h

#include "pqHapticSettingRows.h"

#include <QList>
#include <QWidget>

class QFormLayout;
class QLabel;
class QPushButton;
class pqHapticDeviceChoice;
class pqHapticProgress;
class pqHapticRecordingRows;
class pqHapticStrip;
class pqPropertyLinks;
class vtkHapticSession;
class vtkSMProxy;

/**
 * What a person needs all day, on one screen: device, Touch, one line that says how it is and what to do, Fit, radius,
 * stiffness, recordings, and strip charts of the last ten seconds.
 */
class pqHapticMainGroup : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticMainGroup(QWidget* parent = nullptr);
  ~pqHapticMainGroup() override;

  /// Null: nothing can be set, and `refresh` says why.
  void setProxy(vtkSMProxy* proxy, pqPropertyLinks& links);
  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  void addDevice(QFormLayout* form);
  void addButtons(QFormLayout* form);
  void addStrips(QFormLayout* form);
  QString statusOf(vtkHapticSession* session) const;
  QString serverOf(vtkHapticSession* session) const;
  void followStrips(vtkHapticSession* session);

  pqHapticDeviceChoice* Device;
  QPushButton* Touch;
  QPushButton* Release;
  QPushButton* Fit;
  QLabel* Status;
  pqHapticProgress* Progress;
  QLabel* Server;
  QLabel* MouseHelp;
  pqHapticSettingRows Rows; ///< stiffness and radius
  pqHapticRecordingRows* Recording;
  pqHapticStrip* Force;
  pqHapticStrip* Depth;
  pqHapticStrip* Lateness;
  pqHapticStrip* Energy;
};

#endif
