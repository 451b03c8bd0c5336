// SPDX-License-Identifier: GPL-3.0-or-later
#include "pqHapticHandKeys.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QApplication>
#include <QKeyEvent>

namespace
{
/// The property that a key holds on; null: it holds none.
const char* PropertyOf(const QKeyEvent& key)
{
  const bool meant =
    (key.modifiers() & (Qt::ControlModifier | Qt::ShiftModifier)) == (Qt::ControlModifier | Qt::ShiftModifier);
  return !meant ? nullptr : key.key() == Qt::Key_C ? "Clutch" : key.key() == Qt::Key_P ? "Precision" : nullptr;
}
} // namespace

pqHapticHandKeys::pqHapticHandKeys(QObject* parent) : Superclass(parent)
{
  qApp->installEventFilter(this);
  this->connect(qApp, &QGuiApplication::applicationStateChanged, this, &pqHapticHandKeys::letGo);
}

pqHapticHandKeys::~pqHapticHandKeys() = default;

void pqHapticHandKeys::setProxy(vtkSMProxy* proxy)
{
  this->letGo();
  this->Proxy = proxy;
}

bool pqHapticHandKeys::eventFilter(QObject* object, QEvent* event)
{
  const bool pressed = event->type() == QEvent::KeyPress;
  if ((!pressed && event->type() != QEvent::KeyRelease) || !this->Proxy ||
      vtkSMPropertyHelper(this->Proxy, "Touching").GetAsInt() == 0)
  {
    return this->Superclass::eventFilter(object, event);
  }
  const auto& key = static_cast<const QKeyEvent&>(*event);
  const char* const property = PropertyOf(key);
  if (pressed && property)
  {
    this->hold(property);
    return true; // also while it repeats
  }
  if (!pressed && !key.isAutoRepeat() && this->Held)
  {
    this->letGo(); // whichever of its keys went up first
  }
  return this->Superclass::eventFilter(object, event);
}

void pqHapticHandKeys::hold(const char* property)
{
  if (!this->Held)
  {
    this->Held = property;
    vtkSMPropertyHelper(this->Proxy, property).Set(1);
    this->Proxy->UpdateVTKObjects();
  }
}

void pqHapticHandKeys::letGo()
{
  if (this->Held && this->Proxy)
  {
    vtkSMPropertyHelper(this->Proxy, this->Held).Set(0);
    this->Proxy->UpdateVTKObjects();
  }
  this->Held = nullptr;
}
