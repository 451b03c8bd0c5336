// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef pqHapticPanel_h
#define pqHapticPanel_h

#include <QDockWidget>

#include <memory>

class vtkSMProxy;

/**
 * The dock "Haptics": the device, the feel of a touch, and the servo's read-outs.
 *
 * Every edit goes to the session's proxy and every change of the proxy comes back here; the panel holds no state.
 * Every widget has an object name and a unit beside its number. The fields that are used most have mnemonics, none of
 * which is a menu's of ParaView or a button's of its Properties panel; Tab goes through all fields.
 */
class pqHapticPanel : public QDockWidget
{
  Q_OBJECT
  typedef QDockWidget Superclass;

public:
  explicit pqHapticPanel(const QString& title, QWidget* parent = nullptr, Qt::WindowFlags flags = Qt::WindowFlags());
  explicit pqHapticPanel(QWidget* parent = nullptr, Qt::WindowFlags flags = Qt::WindowFlags());
  ~pqHapticPanel() override;

private:
  void build();
  void setProxy(vtkSMProxy* proxy);
  void refresh();

  class Internals;
  std::unique_ptr<Internals> Widgets;
};

#endif
