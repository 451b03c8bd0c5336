// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticWireFile_h
#define vtkHapticWireFile_h

#include <memory>
#include <string>
#include <vector>

#include "haptics/mechanism/wire/WirePlan.h"
#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// A wire in a vessel as a scene file describes it.
struct vtkHapticWireResult
{
  bool IsWire = false; ///< the text is of a wire, with a problem or without
  palpate::WireDescription Description;
  std::shared_ptr<const palpate::TriangleMesh> Vessel; ///< null on a problem
  std::string Text;                                    ///< of the file
  std::string Problem;                                 ///< one line: place in the text, fault, remedy
};

/// Reads a scene file's text (docs/mechanisms.md) whose only body is a wire. The vessel is looked for in `folder`. A
/// text of another mechanism, or none, is no problem: it is no wire.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticWireResult vtkHapticParseWire(
  const std::string& text, const std::string& folder);
/// The wire that data describe; of others it is no wire.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticWireResult vtkHapticToWire(vtkDataObject& data);
/// The same from a file; the problem names it.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticWireResult vtkHapticReadWire(const std::string& file);

/// The vessel of a wire, with its description for Touch Along Path. `folder`: that of its file.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkSmartPointer<vtkPolyData> vtkHapticWireShapes(
  const vtkHapticWireResult& read, const std::string& folder);

/// The lines of a check for a person.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<std::string> vtkHapticWireText(const palpate::WireCheck& check);

#endif
