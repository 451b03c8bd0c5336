// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMarksGroup_h
#define pqHapticMarksGroup_h

#include <QList>
#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QPushButton;
class vtkHapticSession;

/// The marks: one set here, all as a list that says which are stale, in a file, none.
class pqHapticMarksGroup : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticMarksGroup(QWidget* parent = nullptr);

  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  void save();
  void clear();

  QPushButton* Mark;
  QPushButton* Save;
  QPushButton* Clear;
  QLabel* Count;
  QPlainTextEdit* Marks;
};

#endif
