// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliSoft_h
#define vtkHapticCliSoft_h

#include <memory>

#include "haptics/session/soft/BodyMaker.h"
#include "vtkHapticCliCommands.h"

/// The first file as a body that gives way; null where none is asked for. Throws vtkHapticCliProblem.
[[nodiscard]] std::unique_ptr<palpate::BodyMaker> vtkHapticCliBodyOf(const vtkHapticCliTouchOptions& options);

#endif
