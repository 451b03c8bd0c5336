// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticTop_h
#define pqHapticTop_h

#include <QList>
#include <QString>
#include <QWidget>

class QPushButton;
class QStackedWidget;
class QVBoxLayout;
class pqHapticDeviceChoice;
class pqHapticLines;
class pqHapticProgress;
class pqPropertyLinks;
class vtkHapticSession;
class vtkSMProxy;

/**
 * The top of the panel, which never scrolls and whose height never changes: device, Touch, Let Go, Fit, status and
 * remedy, and the contact, or how far large data are from being touched.
 */
class pqHapticTop : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

public:
  explicit pqHapticTop(QWidget* parent = nullptr);
  ~pqHapticTop() override;

  /// Null: nothing can be set, and `refresh` says why.
  void setProxy(vtkSMProxy* proxy, pqPropertyLinks& links);
  /// Null where there is no session. Ten times a second.
  void refresh(vtkHapticSession* session);
  /// In the order of the Tab key.
  QList<QWidget*> fields() const;

private:
  void addDevice(QVBoxLayout* column);
  void addButtons(QVBoxLayout* column);
  void addHints(QVBoxLayout* column);
  QString statusOf(vtkHapticSession* session) const;
  QString serverOf(vtkHapticSession* session) const;
  QString contactOf(vtkHapticSession* session);

  /// The largest values of a contact, which are said until the next one.
  struct Contact
  {
    QString Source;
    double Force_N = 0.0, Depth_mm = 0.0;
    bool Now = false, Ever = false;
  };

  pqHapticDeviceChoice* Device;
  QPushButton* Touch;
  QPushButton* Release;
  QPushButton* Fit;
  pqHapticLines* Status;
  QStackedWidget* Hints; ///< one place for two things that are never needed together
  QWidget* Notes;
  pqHapticLines* ContactLine;
  pqHapticLines* Server;
  pqHapticProgress* Progress;
  Contact Last;
};

#endif
