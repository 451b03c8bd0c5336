// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSourceWatch_h
#define vtkHapticSourceWatch_h

#include "vtkWeakPointer.h"

class vtkSMSourceProxy;

/// Whether a source on a server has made other data since Forget() was called; true at first.
class vtkHapticSourceWatch
{
public:
  explicit vtkHapticSourceWatch(vtkSMSourceProxy* source);
  ~vtkHapticSourceWatch();
  vtkHapticSourceWatch(const vtkHapticSourceWatch&) = delete;
  vtkHapticSourceWatch& operator=(const vtkHapticSourceWatch&) = delete;

  /// Null: it is gone.
  [[nodiscard]] vtkSMSourceProxy* GetSource() const;
  [[nodiscard]] bool HasChanged() const { return this->Changed; }
  /// It is asked now.
  void Forget() { this->Changed = false; }

private:
  void Change() { this->Changed = true; }

  vtkWeakPointer<vtkSMSourceProxy> Source;
  unsigned long Observer;
  bool Changed = true;
};

#endif
