// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticOFFParser_h
#define vtkHapticOFFParser_h

#include "vtkHapticFaceMesh.h"

#include <string_view>

/// Reads the text of an OFF file (Geomview's object file format): the keyword OFF, COFF, NOFF, CNOFF, STOFF or a
/// combination, or none; the three counts; one line per point; one line per face. Colours, normals and texture
/// coordinates behind the numbers that matter are skipped; `#` starts a comment. Binary files, 4OFF and nOFF are
/// refused, and so is a file that holds more or less than its header promises.
/// Memory is bounded by the length of the text, never by its header.
[[nodiscard]] vtkHapticFaceMesh vtkHapticParseOFF(std::string_view text);

#endif
