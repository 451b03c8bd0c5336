// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticDrafts_h
#define vtkHapticDrafts_h

#include "vtkSmartPointer.h" // for the members
#include "vtkWeakPointer.h"  // for the members

#include <map>

class vtkDataObject;
class vtkSMProxy;
class vtkSMSourceProxy;

/**
 * Curves as their widgets draw them, before they are applied.
 *
 * A widget in a view (line, poly line, spline) writes the unchecked values of a source's properties while a handle is
 * dragged; Apply makes them the source's, Reset forgets them. The curve is computed by a copy of the source that is in
 * no pipeline and no view, so neither the source nor the filters behind it change. GUI thread, built-in server.
 */
class vtkHapticDrafts
{
public:
  vtkHapticDrafts();
  ~vtkHapticDrafts();
  vtkHapticDrafts(const vtkHapticDrafts&) = delete;
  void operator=(const vtkHapticDrafts&) = delete;

  /// The curve that `source` would give; null where it has no such widget or an input, or where all it has is applied.
  vtkDataObject* Changed(vtkSMProxy* source);
  /// The curve that `source` would give, applied or not; null where it has no such widget or an input.
  vtkDataObject* Drawn(vtkSMProxy* source);
  /// Whether Changed() or Drawn() gave something of that source.
  bool Knows(vtkSMProxy* source) const;

  void Forget(vtkSMProxy* source);
  /// Copies of sources that are gone.
  void ForgetDeleted();
  void ForgetAll();

private:
  struct Copy
  {
    vtkWeakPointer<vtkSMProxy> Of;
    vtkSmartPointer<vtkSMSourceProxy> Source;
  };

  std::map<vtkSMProxy*, Copy> Copies;
};

#endif
