// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMechanismFile_h
#define vtkHapticMechanismFile_h

#include <memory>
#include <string>
#include <vector>

#include "haptics/core/Outcome.h"
#include "haptics/session/mechanism/MechanismBodies.h"
#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

/// The head of a scene file.
inline constexpr const char* vtkHapticSceneFormat = "palpate mechanism";
inline constexpr int vtkHapticSceneVersion = 1;

/// A mechanism as a scene file describes it, or why it is none.
struct vtkHapticMechanismResult
{
  std::shared_ptr<const palpate::MechanismInputs> Inputs;      ///< null on a problem
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> SoftGrids; ///< as described, in the order of Inputs->soft
  std::string Text;                                            ///< of the file
  std::string Problem;                                         ///< one line: place in the text, fault, remedy
  bool VesselGiven = false;                                    ///< it has a wire that names no file of its vessel
};

/// Reads a scene file's text (docs/mechanisms.md): JSON, `format` "palpate mechanism", `version` 1, bodies,
/// constraints. Files of bodies are looked for in `folder`. Every key is known or refused, so that a mistyped one is
/// not lost. `laws`: a list of constraints in place of its own; "": its own. `read`: soft bodies that were made of the
/// same text before, and are not read again; they have no grids. `vessel_W`: of a wire that names no file of one.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticMechanismResult vtkHapticParseMechanism(const std::string& text,
  const std::string& folder, const std::string& laws = "", const std::vector<palpate::MechanismSoftInput>& read = {},
  const std::shared_ptr<const palpate::TriangleMesh>& vessel_W = nullptr);

/// The list of constraints of a scene file's text, or `laws` where that is not "", with another one at its end, as an
/// object of the file; in the place of the one of its name, if there is one. Throws nothing; "" with a problem.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticWithConstraint(
  const std::string& text, const std::string& laws, const std::string& law, std::string& problem);
/// Likewise without the constraint of that name.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticWithoutConstraint(
  const std::string& text, const std::string& laws, const std::string& name, std::string& problem);

/// The text of a scene file; the problem names it.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT palpate::Outcome<std::string> vtkHapticSceneText(const std::string& file);

/// The same from a file; the problem names it.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticMechanismResult vtkHapticReadMechanism(const std::string& file);

/// Whether a file's name says that it is one: .json, in capitals or not.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticIsMechanismFile(const std::string& file);

#endif
