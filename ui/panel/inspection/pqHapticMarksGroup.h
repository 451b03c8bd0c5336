// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticMarksGroup_h
#define pqHapticMarksGroup_h

#include <QList>
#include <QString>
#include <QWidget>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;
class vtkHapticSession;

/// The marks: a table with number, name, position and validity of each, the distance between two that are chosen, and
/// buttons that set a mark here, delete the chosen ones, look at one, write, read and clear.
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
  void makeTable();
  QPushButton* button(QHBoxLayout* row, const char* name, const QString& title, const QString& tip);
  void fill(vtkHapticSession* session);
  void sayDistance();
  QList<int> chosen() const;
  void rename(QTableWidgetItem* item);
  void save();
  void load();
  void remove();
  void clear();

  QPushButton *Mark, *Delete, *GoTo, *Save, *Load, *Clear;
  QLabel* Count;
  QLabel* Distance;
  QTableWidget* Marks;
  QString Shown; ///< text and validity of the marks that the table has
};

#endif
