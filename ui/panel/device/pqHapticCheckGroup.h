// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticCheckGroup_h
#define pqHapticCheckGroup_h

#include <QGroupBox>
#include <QList>
#include <QString>

class QLabel;
class QProgressBar;
class QPushButton;
class vtkHapticSession;

/// The group "Device check" of the panel: a check of the chosen device, what the person must do for it, what it found.
class pqHapticCheckGroup : public QGroupBox
{
  Q_OBJECT
  typedef QGroupBox Superclass;

public:
  explicit pqHapticCheckGroup(QWidget* parent = nullptr);

  /// What the session says now; null: nothing.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  void startOrStop();
  void keep();

  QPushButton* Verify;
  QPushButton* Adjust;
  QProgressBar* Progress;
  QLabel* Ask;
  QLabel* Result;
  QString Note; ///< stands there instead of a result: what was refused or kept
};

#endif
