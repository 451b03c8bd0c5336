// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticRecordingRows_h
#define pqHapticRecordingRows_h

#include <QList>
#include <QWidget>

class QLineEdit;
class QPushButton;
class pqHapticLines;
class pqPropertyLinks;
class vtkHapticSession;
class vtkSMProxy;

/**
 * Record, save, play again, see the path; the running recording, and the one that is played.
 */
class pqHapticRecordingRows : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticRecordingRows(QWidget* parent = nullptr);
  ~pqHapticRecordingRows() override;

  void link(vtkSMProxy* proxy, pqPropertyLinks& links);
  /// Null where there is no session.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  QPushButton* Record;
  QPushButton* Save;
  QPushButton* Replay;
  QPushButton* Way;
  pqHapticLines* Text;
  QWidget* Played; ///< the recording of the device that plays one
  QLineEdit* ReplayFile;
  QPushButton* Browse;
};

#endif
