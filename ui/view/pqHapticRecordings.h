// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticRecordings_h
#define pqHapticRecordings_h

#include <QObject>
#include <QString>

#include "vtkSmartPointer.h"

class QAction;
class vtkSMProxy;

/**
 * What a person does with recordings: record, save, play again, and see the way of the hand as a source.
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
  /// The device `replay` plays from its beginning.
  void replay();
  /// Opens the path of the recording in the pipeline.
  void showWay();

private:
  void record(bool on);

  vtkSmartPointer<vtkSMProxy> Proxy;
  QAction* RecordAction;
};

#endif
