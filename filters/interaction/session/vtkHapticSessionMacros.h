// SPDX-License-Identifier: GPL-3.0-or-later
// Declarations of read-outs that haptics/session/settings/ describes.
#ifndef vtkHapticSessionMacros_h
#define vtkHapticSessionMacros_h

#include "vtkSetGet.h"
#include "vtkWrappingHints.h"

/// A read-out: a number, a text, several numbers.
#define vtkHapticReadoutMacro(name, type)                                                                              \
  type Get##name() const                                                                                               \
  {                                                                                                                    \
    return static_cast<type>(this->GetReadout(#name));                                                                 \
  }
#define vtkHapticTextMacro(name)                                                                                       \
  const char* Get##name() const                                                                                        \
  {                                                                                                                    \
    return this->GetReadoutText(#name);                                                                                \
  }
#define vtkHapticNumbersMacro(name, count)                                                                             \
  double* Get##name() VTK_SIZEHINT(count)                                                                              \
  {                                                                                                                    \
    return this->GetReadoutNumbers(#name);                                                                             \
  }

#endif
