// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticContactGroup_h
#define pqHapticContactGroup_h

#include <QWidget>

class QFormLayout;
class QLabel;
class vtkHapticSession;

/// Data at the contact, or at the last one, each number with its unit. They are looked up only while these rows are
/// visible.
class pqHapticContactGroup : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticContactGroup(QWidget* parent = nullptr);

  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);

private:
  void showContact(vtkHapticSession& session);

  QLabel* add(QFormLayout* form, const char* name, const QString& title, const QString& tip);

  QLabel* When;   ///< whether the data are those of a contact now
  QWidget* Found; ///< the rows, once there was a contact
  QLabel* Source;
  QLabel* Ids;
  QLabel* Position;
  QLabel* Normal;
  QLabel* Depth;
  QLabel* Curvature;
  QLabel* Thickness;
  QLabel* Arrays;
};

#endif
