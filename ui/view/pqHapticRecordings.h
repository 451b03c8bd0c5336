// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticRecordings_h
#define pqHapticRecordings_h

#include <QObject>
#include <QString>

#include "vtkSmartPointer.h"

class QAction;
class vtkSMProxy;

/**
 * A person's actions on recordings: record, save, play again, and see the path of the hand as a source.
 *
 * All of it goes through properties of the session's proxy, so that traces have it. GUI thread only.
 */
class pqHapticRecordings : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  explicit pqHapticRecordings(QObject* parent);
  ~pqHapticRecordings() override;

  void setProxy(vtkSMProxy* proxy);
  /// Records while it is checked: menu and key.
  QAction* recordAction() const { return this->RecordAction; }
  /// The proxy has changed.
  void follow();

public Q_SLOTS:
  /// Gives the last recording a name that the person is asked for.
  void save();
  /// Asks which recording is to be played.
  void open();
  /// The device `replay` plays from its beginning, a recording that is running once it has ended; when touching ends
  /// the device of before is chosen again.
  void replay();
  /// Opens the path of the recording in the pipeline.
  void showWay();

private:
  void record(bool on);
  void play();

  vtkSmartPointer<vtkSMProxy> Proxy;
  QString Before;       ///< the device that played before a replay; "": no replay of ours
  bool Awaited = false; ///< the recording that is to be played has not ended yet
  QAction* RecordAction;
};

#endif
