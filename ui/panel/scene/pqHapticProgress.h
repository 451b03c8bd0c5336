// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticProgress_h
#define pqHapticProgress_h

#include <QWidget>

class QProgressBar;
class QPushButton;
class vtkHapticSession;

/// How far large data are from being touched, and a button that gives it up; to be seen only while a person waits for
/// it.
class pqHapticProgress : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticProgress(QWidget* parent = nullptr);
  ~pqHapticProgress() override;

  /// Null: no session. Called ten times a second.
  void refresh(vtkHapticSession* session);
  /// Whether a person waits for it.
  bool waits() const;
  QWidget* field() const;

private:
  QProgressBar* Bar;
  QPushButton* Cancel;
  int Waited = 0; ///< looks at something that is not ready
};

#endif
